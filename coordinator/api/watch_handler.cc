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

// `go_on` may read files.
absl::Status AskWithoutLock(ClusterLock& lock, const WatchHandler::GoOn& go_on) {
  lock.unlock();
  absl::Status status = go_on();
  lock.lock();
  return status;
}

}  // namespace

absl::Status WatchHandler::WatchJob(const v1::WatchJobRequest& request, const std::function<bool(const v1::Job&)>& send,
                                    const GoOn& go_on) {
  std::atomic<bool> gives_way{false};
  TILEMEND_ASSIGN_OR_RETURN(const auto call, Enter(request.name(), gives_way));
  uint64_t cursor = request.cursor();
  SteadyTime next_send{};
  ClusterLock lock(cluster_.mutex);
  while (!gives_way) {
    TILEMEND_ASSIGN_OR_RETURN(const Job* job, cluster_.JobNamed(request.name()));
    const SteadyTime now = std::chrono::steady_clock::now();
    const bool over = IsOver(job->state);
    if (over || (job->version > cursor && now >= next_send)) {
      const v1::Job message = DescribeJob(cluster_, *job);
      lock.unlock();
      cluster_.journal->Await();
      if (!send(message)) return absl::CancelledError("the watcher went away");
      if (over) return absl::OkStatus();
      call->Touch(cluster_.options.clock());
      cursor = message.cursor();
      next_send = now + kWatchInterval;
      lock.lock();
      continue;
    }
    if (cluster_.stopping)
      return absl::UnavailableError("the coordinator is shutting down; watch again with the last cursor");
    cluster_.job_changed.wait_until(lock,
                                    job->version > cursor ? next_send : now + absl::ToChronoMilliseconds(kMaxPoll));
    TILEMEND_RETURN_IF_ERROR(AskWithoutLock(lock, go_on));
  }
  return absl::OkStatus();
}

absl::Status WatchHandler::WatchDemand(const std::function<bool(bool)>& send, const GoOn& go_on) {
  std::atomic<bool> gives_way{false};
  TILEMEND_ASSIGN_OR_RETURN(const auto call, Enter("", gives_way));
  std::optional<bool> told;
  ClusterLock lock(cluster_.mutex);
  while (!cluster_.stopping && !gives_way) {
    const bool active = DemandOf(cluster_.state).jobs > 0;
    if (told != active) {
      lock.unlock();
      if (!send(active)) return absl::CancelledError("the watcher went away");
      call->Touch(cluster_.options.clock());
      told = active;
      lock.lock();
      continue;
    }
    cluster_.job_changed.wait_for(lock, absl::ToChronoMilliseconds(kMaxPoll));
    TILEMEND_RETURN_IF_ERROR(AskWithoutLock(lock, go_on));
  }
  return gives_way ? absl::OkStatus() : absl::UnavailableError("the coordinator is shutting down");
}

absl::StatusOr<std::unique_ptr<LongCalls::Call>> WatchHandler::Enter(const std::string& job,
                                                                     std::atomic<bool>& gives_way) {
  return watches_.Enter(job, cluster_.options.clock(), [this, &gives_way] {
    gives_way = true;
    cluster_.job_changed.notify_all();  // one that misses it looks after kMaxPoll
  });
}

}  // namespace tilemend
