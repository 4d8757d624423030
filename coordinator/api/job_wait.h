// A watch of a job that takes one state and no thread, for calls that are answered once.
#ifndef TILEMEND_COORDINATOR_API_JOB_WAIT_H_
#define TILEMEND_COORDINATOR_API_JOB_WAIT_H_

#include <functional>
#include <memory>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "coordinator/api/watch_handler.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// A caller that waits longer asks again. Proxies cut silent connections off after 60 s and more.
inline constexpr absl::Duration kLongestJobWait = absl::Seconds(20);

// Calls `wake` once: when the job has a state after `request.cursor`, is over, or is not there; after kLongestJobWait;
// when `may_go_on`, which is asked once a second, gives an error; when the coordinator ends; when too many watch. That
// may be before this returns, or on another thread. Once the result is let go nothing is called. `watches` must outlive
// it.
std::shared_ptr<void> AwaitJob(WatchHandler& watches, const v1::WatchJobRequest& request,
                               std::function<absl::Status()> may_go_on, std::function<void()> wake);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_JOB_WAIT_H_
