// How much memory several threads may take at once for something that each does for a moment.
#ifndef TILEMEND_COMMON_UTIL_MEMORY_BUDGET_H_
#define TILEMEND_COMMON_UTIL_MEMORY_BUDGET_H_

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace tilemend {

// Thread-safe. In the order in which they came, threads wait until what they need fits beside what others have. One
// that needs more than there is waits until nobody has any.
class MemoryBudget {
 public:
  explicit MemoryBudget(int64_t bytes) : bytes_(bytes) {}

  // What a thread has until this goes.
  class Share {
   public:
    Share(MemoryBudget& budget, int64_t bytes);
    ~Share();
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;

   private:
    MemoryBudget& budget_;
    const int64_t bytes_;
  };

 private:
  const int64_t bytes_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int64_t taken_ = 0;
  uint64_t came_ = 0, admitted_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_MEMORY_BUDGET_H_
