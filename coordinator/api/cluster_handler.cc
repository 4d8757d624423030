#include "coordinator/api/cluster_handler.h"

#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "coordinator/api/page.h"
#include "coordinator/jobs/job_proto.h"

namespace tilemend {
namespace {

constexpr int kMostTasksShown = 16;

void AddTasks(const Cluster& cluster, const WorkerRecord& worker, v1::WorkerInfo& info) {
  for (const TaskKey& key : worker.held) {
    const Task* const task = cluster.state.FindTask(key);
    if (task == nullptr || info.doing_size() >= kMostTasksShown) continue;
    v1::WorkerTask& shown = *info.add_doing();
    shown.set_job(absl::StrCat("jobs/", key.job));
    shown.set_stage(std::string(StageName(task->stage)));
    shown.set_col(task->cell.col);
    shown.set_row(task->cell.row);
    if (const Lease* const lease = LeaseOf(*task, worker.id)) SetTime(lease->since, *shown.mutable_since());
  }
}

v1::WorkerInfo DescribeWorker(const Cluster& cluster, const WorkerRecord& worker) {
  v1::WorkerInfo info;
  info.set_id(worker.id);
  info.set_threads(worker.threads);
  info.set_tasks(static_cast<int32_t>(worker.held.size()));
  SetTime(worker.last_seen, *info.mutable_last_seen());
  if (const auto caller = cluster.callers.find(worker.id); caller != cluster.callers.end()) {
    info.set_release(caller->second.release);
    info.set_identity(caller->second.identity);
    SetTime(caller->second.first_seen, *info.mutable_first_seen());
  }
  AddTasks(cluster, worker, info);
  info.set_message(cluster.trust.WhySetAside(worker.id));
  info.set_state(!info.message().empty() ? v1::SET_ASIDE : worker.draining ? v1::DRAINING : v1::WORKING);
  if (const std::vector<std::string> jobs = cluster.trust.BlindTo(worker.id); info.message().empty() && !jobs.empty()) {
    info.set_message(absl::StrCat("does not see the folders of jobs/", absl::StrJoin(jobs, ", jobs/")));
  }
  return info;
}

}  // namespace

absl::StatusOr<v1::ListWorkersResponse> ClusterHandler::ListWorkers(const v1::ListWorkersRequest& request) {
  if (request.page_size() < 0) return InvalidPage("page_size: below 0");
  ClusterLock lock(cluster_.mutex);
  v1::ListWorkersResponse response;
  // The token is the last worker that was shown.
  auto it = cluster_.state.workers().upper_bound(request.page_token());
  for (; it != cluster_.state.workers().end() && response.workers_size() < PageSize(request.page_size()); ++it) {
    *response.add_workers() = DescribeWorker(cluster_, it->second);
  }
  if (it != cluster_.state.workers().end()) response.set_next_page_token(std::prev(it)->first);
  return response;
}

Demand ClusterHandler::DemandNow() {
  return AnswerWhenDurable(cluster_, [&] { return DemandOf(cluster_.state); });
}

}  // namespace tilemend
