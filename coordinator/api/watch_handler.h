// Calls that follow jobs and the demand for workers.
#ifndef TILEMEND_COORDINATOR_API_WATCH_HANDLER_H_
#define TILEMEND_COORDINATOR_API_WATCH_HANDLER_H_

#include <functional>

#include "absl/status/status.h"
#include "coordinator/api/long_calls.h"
#include "coordinator/jobs/cluster.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// Thread-safe. Each call waits for news. kResourceExhausted (TOO_MANY_CALLS) if too many wait, kUnavailable when the
// coordinator ends.
class WatchHandler {
 public:
  // `cluster` must outlive this.
  explicit WatchHandler(Cluster& cluster) : cluster_(cluster) {}

  // Calls `send` for each state of the job as the message says, and at least once a second `alive`; ends when the job
  // is over (OK) or either returns false (kCancelled).
  absl::Status WatchJob(const v1::WatchJobRequest& request, const std::function<bool(const v1::Job&)>& send,
                        const std::function<bool()>& alive);
  // As WatchJob, of whether there is anything to do: now, and after each change.
  absl::Status WatchDemand(const std::function<bool(bool)>& send, const std::function<bool()>& alive);

 private:
  Cluster& cluster_;
  LongCalls watches_{500};  // threads at most
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_WATCH_HANDLER_H_
