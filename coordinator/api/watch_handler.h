// Calls that follow jobs and the demand for workers.
#ifndef TILEMEND_COORDINATOR_API_WATCH_HANDLER_H_
#define TILEMEND_COORDINATOR_API_WATCH_HANDLER_H_

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/api/long_calls.h"
#include "coordinator/jobs/cluster.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// Thread-safe. Each call waits for news. If too many wait, the one that has had no news for longest ends (OK) and makes
// room; its caller may watch again. Returns kUnavailable when the coordinator ends.
class WatchHandler {
 public:
  // Why a call is to end, or OK. Called at least once a second, without a lock.
  using GoOn = std::function<absl::Status()>;

  // `cluster` must outlive this.
  explicit WatchHandler(Cluster& cluster) : cluster_(cluster) {}

  // Calls `send` for each state of the job as the message says. Ends when the job is over (OK), when `send` returns
  // false (kCancelled) and with the error of `go_on`.
  absl::Status WatchJob(const v1::WatchJobRequest& request, const std::function<bool(const v1::Job&)>& send,
                        const GoOn& go_on);
  // As WatchJob, of whether there is anything to do: now, and after each change.
  absl::Status WatchDemand(const std::function<bool(bool)>& send, const GoOn& go_on);

 private:
  // `gives_way` becomes true when another watch takes the place of this one; it outlives what is returned.
  absl::StatusOr<std::unique_ptr<LongCalls::Call>> Enter(const std::string& job, std::atomic<bool>& gives_way);

  Cluster& cluster_;
  LongCalls watches_{500, LongCalls::WhenFull::kStopOldest};  // threads
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_WATCH_HANDLER_H_
