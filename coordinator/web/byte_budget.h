// Bytes of memory that several threads share.
#ifndef TILEMEND_COORDINATOR_WEB_BYTE_BUDGET_H_
#define TILEMEND_COORDINATOR_WEB_BYTE_BUDGET_H_

#include <cstdint>
#include <memory>
#include <mutex>

namespace tilemend {

// Thread-safe. Must outlive its shares.
class ByteBudget {
 public:
  // Bytes that are taken until it ends.
  class Share {
   public:
    Share(ByteBudget& from, int64_t bytes) : from_(from), bytes_(bytes) {}
    ~Share() { from_.GiveBack(bytes_); }
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;

    // Gives back what is more than `bytes`. Of one thread at a time.
    void ShrinkTo(int64_t bytes) {
      if (bytes >= bytes_) return;
      from_.GiveBack(bytes_ - bytes);
      bytes_ = bytes;
    }

   private:
    ByteBudget& from_;
    int64_t bytes_;
  };

  explicit ByteBudget(int64_t bytes) : left_(bytes) {}

  // Null if less than that is left.
  std::shared_ptr<Share> Take(int64_t bytes) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (bytes > left_) return nullptr;
      left_ -= bytes;
    }
    return std::make_shared<Share>(*this, bytes);
  }

 private:
  void GiveBack(int64_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    left_ += bytes;
  }

  std::mutex mutex_;
  int64_t left_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_BYTE_BUDGET_H_
