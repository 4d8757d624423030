#include "coordinator/jobs/housekeeping.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "common/util/heap.h"
#include "coordinator/state/patience.h"
#include "coordinator/state/task_choice.h"

namespace tilemend {
namespace {

// Each takes some KB: its paths, its error, its warnings.
constexpr size_t kMostJobsOver = 10'000;

}  // namespace

void Housekeeping::StopTicking() {
  if (ticker_.joinable()) ticker_.join();
}

void Housekeeping::StartTicking() {
  ticker_ = std::thread([this] { TickLoop(); });
}

void Housekeeping::Tick() {
  std::vector<std::unique_ptr<JobRunner>> ended;
  ClusterLock lock(cluster_.mutex);
  const absl::Time now = cluster_.options.clock();
  const std::vector<Event> overdue =
      may_lose_ ? Overdue(cluster_.state, now, cluster_.options.lease, WorkersBeingChecked(cluster_))
                : std::vector<Event>();
  for (const Event& event : overdue) {
    if (const auto* lost = std::get_if<WorkerLost>(&event)) {
      cluster_.events.WorkerLost(*cluster_.state.FindWorker(lost->worker), now);
      cluster_.callers.erase(lost->worker);
      cluster_.trust.RemoveWorker(lost->worker);
    }
    updates_.Apply(event).IgnoreError();
  }
  for (const Event& event : Abandoned(cluster_.state, now, cluster_.MayWorkNow())) updates_.Apply(event).IgnoreError();
  for (auto& [id, entry] : cluster_.jobs) {
    if (entry.runner == nullptr || !entry.runner->ended()) continue;
    ended.push_back(std::move(entry.runner));
    cluster_.trust.RemoveJob(id);
    entry.blobs.reset();
  }
  std::erase_if(cluster_.callers, [&](const auto& caller) {
    return caller.second.left && *caller.second.left + cluster_.options.lease < now;
  });
  ForgetOldJobs(now);
  on_tick_(now);
  cluster_.ShowMetrics();
  lock.unlock();  // before the runners are joined
  if (ended.empty()) return;
  ended.clear();
  ReturnHeap();  // what a large job took stays with the process otherwise
}

void Housekeeping::TickLoop() {
  const absl::Duration interval = std::min(cluster_.options.lease / 4, absl::Seconds(1));
  Patience patience(interval, cluster_.options.lease);
  ClusterLock lock(cluster_.mutex);
  while (!cluster_.stopping) {
    cluster_.stop_changed.wait_for(lock, absl::ToChronoMilliseconds(interval));
    if (cluster_.stopping) return;
    may_lose_ = patience.IsOver(cluster_.options.clock());
    lock.unlock();
    Tick();
    lock.lock();
  }
}

void Housekeeping::ForgetOldJobs(absl::Time now) {
  if (cluster_.state.job_numbers().empty()) return;
  const int64_t newest = cluster_.state.job_numbers().rbegin()->first;  // stays, or its number would be given out again
  size_t over = cluster_.state.job_numbers().size() - cluster_.state.running().size();
  std::vector<std::string> old;
  for (const auto& [number, id] : cluster_.state.job_numbers()) {
    const Job& job = *cluster_.state.FindJob(id);
    if (!IsOver(job.state) || cluster_.jobs.at(id).runner != nullptr || number == newest) continue;
    if (over <= kMostJobsOver && job.ended + cluster_.options.keep_jobs > now) continue;
    --over;
    old.push_back(id);
    cluster_.journal->DropJob(number);
  }
  for (const std::string& id : old) {
    updates_.Apply(JobForgotten{id}).IgnoreError();
    cluster_.jobs.erase(id);
  }
  if (!old.empty()) cluster_.job_changed.notify_all();
}

}  // namespace tilemend
