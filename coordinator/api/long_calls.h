// Calls that wait for others. Each takes memory, and a stream of a blob a thread. So they are counted and looked after.
#ifndef TILEMEND_COORDINATOR_API_LONG_CALLS_H_
#define TILEMEND_COORDINATOR_API_LONG_CALLS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/time/time.h"

namespace tilemend {

// Thread-safe.
class LongCalls {
 public:
  // What a further call does to `most` others.
  enum class WhenFull {
    kRefuse,      // it is refused
    kStopOldest,  // it takes the place of the one that has not got on for longest, which is stopped
  };
  explicit LongCalls(size_t most, WhenFull when_full = WhenFull::kRefuse) : most_(most), when_full_(when_full) {}

  // One call, while this lives.
  class Call {
   public:
    Call(LongCalls& calls, uint64_t number) : calls_(calls), number_(number) {}
    ~Call() { calls_.Leave(number_); }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;
    // Whose it is, where that is known later.
    void Name(std::string job) { calls_.Name(number_, std::move(job)); }
    // It has got on.
    void Touch(absl::Time now) { calls_.Touch(number_, now); }

   private:
    LongCalls& calls_;
    const uint64_t number_;
  };

  // Calling `stop` makes the call end soon. It may be called until the Call is gone, and must not wait for that.
  // Returns kResourceExhausted (TOO_MANY_CALLS) if there are too many; with kStopOldest if as many again are about to
  // end.
  absl::StatusOr<std::unique_ptr<Call>> Enter(std::string job, absl::Time now, std::function<void()> stop);

  // Stops the calls that have not got on since `since`, and those of jobs that are over.
  void Stop(absl::Time since, const std::function<bool(const std::string& job)>& is_over);

 private:
  struct Entry {
    std::string job;
    absl::Time last;
    std::function<void()> stop;
    bool is_stopped = false;  // by a later one
  };
  void StopOldest();
  void Name(uint64_t number, std::string job);
  void Touch(uint64_t number, absl::Time now);
  void Leave(uint64_t number);

  const size_t most_;
  const WhenFull when_full_;
  std::mutex mutex_;
  uint64_t last_ = 0;
  size_t stopped_ = 0;  // entries with is_stopped
  std::map<uint64_t, Entry> entries_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_LONG_CALLS_H_
