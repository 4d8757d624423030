#include "coordinator/api/job_wait.h"

#include <mutex>
#include <utility>

#include "absl/time/clock.h"

namespace tilemend {
namespace {

class JobWait : public Watcher {
 public:
  JobWait(WatchHandler& watches, std::function<absl::Status()> may_go_on, std::function<void()> wake)
      : watches_(watches), may_go_on_(std::move(may_go_on)), wake_(std::move(wake)) {}

  static void Begin(const std::shared_ptr<JobWait>& wait, const v1::WatchJobRequest& request) {
    wait->self_ = wait;
    if (wait->watches_.WatchJob(request, wait->watch_).ok()) return;
    wait->Wake();  // the caller asks once more, and is told why
    wait->self_ = nullptr;
  }

  // Nothing of the caller's is used from now on.
  void Leave() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      has_left_ = true;
    }
    watches_.Gone(watch_);
  }

 private:
  absl::Status GoOn() override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (has_left_ || absl::Now() - begin_ > kLongestJobWait) return absl::DeadlineExceededError("waits no longer");
    return may_go_on_();
  }
  void Send(const WatchNews&) override { Wake(); }
  void End(const absl::Status&) override {
    Wake();
    const auto self = std::exchange(self_, nullptr);  // perhaps the last that knows this
  }
  void Wake() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!has_left_ && !std::exchange(is_awake_, true)) wake_();
  }

  WatchHandler& watches_;
  const std::function<absl::Status()> may_go_on_;
  const std::function<void()> wake_;
  const absl::Time begin_ = absl::Now();
  const std::shared_ptr<Watch> watch_ = NewWatch(*this);
  std::shared_ptr<JobWait> self_;  // until the watch has ended
  std::mutex mutex_;               // guards all below, and calls of the caller's functions
  bool has_left_ = false;
  bool is_awake_ = false;
};

}  // namespace

std::shared_ptr<void> AwaitJob(WatchHandler& watches, const v1::WatchJobRequest& request,
                               std::function<absl::Status()> may_go_on, std::function<void()> wake) {
  const auto wait = std::make_shared<JobWait>(watches, std::move(may_go_on), std::move(wake));
  JobWait::Begin(wait, request);
  return {wait.get(), [wait](void*) { wait->Leave(); }};
}

}  // namespace tilemend
