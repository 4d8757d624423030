#include "coordinator/api/watch_handler.h"

#include <chrono>
#include <cstdint>
#include <optional>

#include "common/rpc/limits.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/describe_job.h"
#include "coordinator/state/demand.h"

namespace tilemend {
namespace {

using SteadyTime = std::chrono::steady_clock::time_point;

constexpr std::chrono::milliseconds kWatchInterval(50);

}  // namespace

absl::Status WatchHandler::WatchJob(const v1::WatchJobRequest& request, const std::function<bool(const v1::Job&)>& send,
                                    const std::function<bool()>& alive) {
  TILEMEND_ASSIGN_OR_RETURN(const auto call, watches_.Enter(request.name(), cluster_.options.clock(), [] {}));
  uint64_t cursor = request.cursor();
  SteadyTime next_send{};
  ClusterLock lock(cluster_.mutex);
  while (true) {
    TILEMEND_ASSIGN_OR_RETURN(const Job* job, cluster_.JobNamed(request.name()));
    const SteadyTime now = std::chrono::steady_clock::now();
    const bool over = IsOver(job->state);
    if (over || (job->version > cursor && now >= next_send)) {
      const v1::Job message = DescribeJob(cluster_, *job);
      lock.unlock();
      cluster_.journal->Await();
      if (!send(message)) return absl::CancelledError("the watcher went away");
      if (over) return absl::OkStatus();
      cursor = message.cursor();
      next_send = now + kWatchInterval;
      lock.lock();
      continue;
    }
    if (cluster_.stopping)
      return absl::UnavailableError("the coordinator is shutting down; watch again with the last cursor");
    cluster_.job_changed.wait_until(lock,
                                    job->version > cursor ? next_send : now + absl::ToChronoMilliseconds(kMaxPoll));
    if (!alive()) return absl::CancelledError("the watcher went away");
  }
}

absl::Status WatchHandler::WatchDemand(const std::function<bool(bool)>& send, const std::function<bool()>& alive) {
  TILEMEND_ASSIGN_OR_RETURN(const auto call, watches_.Enter("", cluster_.options.clock(), [] {}));
  std::optional<bool> told;
  ClusterLock lock(cluster_.mutex);
  while (!cluster_.stopping) {
    const bool active = DemandOf(cluster_.state).jobs > 0;
    if (told != active) {
      lock.unlock();
      if (!send(active)) return absl::CancelledError("the watcher went away");
      told = active;
      lock.lock();
      continue;
    }
    cluster_.job_changed.wait_for(lock, absl::ToChronoMilliseconds(kMaxPoll));
    if (!alive()) return absl::CancelledError("the watcher went away");
  }
  return absl::UnavailableError("the coordinator is shutting down");
}

}  // namespace tilemend
