#include "coordinator/api/worker_reports.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/api/task_ref.h"

namespace tilemend {
namespace {

bool IsSameCaller(const WorkerCaller& known, const v1::SyncRequest& request, const std::string& identity) {
  return known.secret == request.secret() && known.identity == identity;
}

}  // namespace

void WorkerReports::CountChecks(const WorkerSync& sync, int change) {
  const auto caller = cluster_.callers.find(sync.request.worker());
  if (caller == cluster_.callers.end() || !IsSameCaller(caller->second, sync.request, sync.identity)) return;
  caller->second.calls = std::max(0, caller->second.calls + change);
  // Its silence begins when it has been looked at.
  const WorkerRecord* worker = cluster_.state.FindWorker(sync.request.worker());
  if (worker == nullptr) return;
  updates_.Apply(WorkerSeen{worker->id, worker->threads, worker->draining, cluster_.options.clock(), worker->prefetch})
      .IgnoreError();
  RenewHeld(sync.request);
}

std::vector<ResultIntake::Report> WorkerReports::Check(v1::SyncRequest& request) { return results_.Prepare(request); }

absl::Status WorkerReports::TakeOver(const v1::SyncRequest& request, const std::string& identity) {
  const WorkerCaller caller{0, request.secret(), request.release(), identity, cluster_.options.clock()};
  WorkerCaller& known = cluster_.callers.try_emplace(request.worker(), caller).first->second;
  if (known.left) {
    const bool is_late = IsSameCaller(known, request, identity) && request.sequence() < known.sequence;
    if (is_late) return absl::AbortedError("this worker has left");
    known = caller;
  }
  if (IsSameCaller(known, request, identity)) {
    known.sequence = std::max(known.sequence, request.sequence());
    return absl::OkStatus();
  }
  return WithErrorInfo(
      absl::PermissionDeniedError(absl::StrCat("another process is worker ", Printable(request.worker()))),
      {"WORKER_SECRET", {}});
}

absl::Status WorkerReports::Take(WorkerSync& sync, std::vector<ResultIntake::Report> reports, ClusterLock& lock) {
  const v1::SyncRequest& request = sync.request;
  const bool is_new = cluster_.state.FindWorker(request.worker()) == nullptr;
  TILEMEND_RETURN_IF_ERROR(updates_
                               .Apply(WorkerSeen{request.worker(), request.threads(), request.draining(),
                                                 cluster_.options.clock(), request.prefetch()})
                               .status());
  if (is_new) {
    cluster_.events.WorkerCame(*cluster_.state.FindWorker(request.worker()), request.release(), sync.identity);
    cluster_.ShowMetrics();
  }
  TakeResults(request, std::move(reports), lock, sync.response);
  if (const std::vector<std::string> unseen = TakeSeen(request); !unseen.empty()) {
    lock.unlock();
    FailJobsThatAreGone(unseen);
    lock.lock();
  }
  return absl::OkStatus();
}

void WorkerReports::TakeResults(const v1::SyncRequest& request, std::vector<ResultIntake::Report> reports,
                                ClusterLock& lock, v1::SyncResponse& response) {
  const std::vector<ResultIntake::Discarded> discarded = results_.Take(request.worker(), std::move(reports), response);
  RenewHeld(request);
  if (discarded.empty()) return;
  lock.unlock();
  ResultIntake::Remove(discarded);
  lock.lock();
}

std::vector<std::string> WorkerReports::TakeSeen(const v1::SyncRequest& request) {
  std::vector<std::string> unseen;
  if (request.seen().empty()) return unseen;
  std::set<std::string> told;
  for (const v1::FoldersSeen& seen : request.seen()) {
    if (!told.insert(seen.job()).second) continue;  // a worker says it once
    const auto warning = cluster_.trust.TakeSeen(request.worker(), seen, cluster_.options.clock());
    if (!warning) continue;
    updates_.Warn(seen.job(), *warning);
    cluster_.events.WorkerBlind(request.worker(), seen.job(), *warning);
    unseen.push_back(seen.job());
  }
  cluster_.metrics.ShowTrust(cluster_.trust.Count());
  return unseen;
}

// A job whose folders the coordinator does not see either any more, or where it cannot write, has no worker to wait
// for.
void WorkerReports::FailJobsThatAreGone(const std::vector<std::string>& jobs) {
  for (const std::string& job : jobs) {
    JobFolders folders;
    {
      ClusterLock lock(cluster_.mutex);
      const JobFolders* known = cluster_.trust.FoldersOf(job);
      if (known == nullptr) continue;
      folders = *known;
    }
    const absl::Status fault = TryFolders(folders);
    if (fault.ok()) continue;
    ClusterLock lock(cluster_.mutex);
    const auto entry = cluster_.jobs.find(job);
    if (entry == cluster_.jobs.end() || entry->second.runner == nullptr) continue;
    entry->second.runner->inbox().Fail(fault);
  }
}

void WorkerReports::RenewHeld(const v1::SyncRequest& request) {
  const absl::Time deadline = cluster_.options.clock() + cluster_.options.lease;
  const std::set<uint64_t> begun(request.begun().begin(), request.begun().end());
  for (const v1::TaskRef& ref : request.held()) {
    const uint64_t token = ref.attempt_token();
    // Fails if the lease was lost; TellState then leaves the task out.
    updates_.Apply(LeaseRenewed{KeyOf(ref), request.worker(), token, deadline, begun.contains(token)}).IgnoreError();
  }
  for (const v1::FinishedTask& finished : request.finished()) {  // whose results are not taken yet
    const v1::TaskRef& ref = finished.ref();
    updates_.Apply(LeaseRenewed{KeyOf(ref), request.worker(), ref.attempt_token(), deadline, true}).IgnoreError();
  }
}

}  // namespace tilemend
