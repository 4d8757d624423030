// Asks a computation on another thread to stop.
#ifndef TILEMEND_COMMON_UTIL_CANCEL_TOKEN_H_
#define TILEMEND_COMMON_UTIL_CANCEL_TOKEN_H_

#include <atomic>

namespace tilemend {

// Set once, never reset. Any thread may set it and any thread may look. A computation looks at it between steps of
// about 10 ms and returns absl::CancelledError when it is set; it leaves nothing half-written.
class CancelToken {
 public:
  CancelToken() = default;
  CancelToken(const CancelToken&) = delete;
  CancelToken& operator=(const CancelToken&) = delete;

  void Cancel() { cancelled_.store(true, std::memory_order_release); }
  bool cancelled() const { return cancelled_.load(std::memory_order_acquire); }

 private:
  std::atomic<bool> cancelled_{false};
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_CANCEL_TOKEN_H_
