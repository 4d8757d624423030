#include "coordinator/api/worker_news.h"

#include <chrono>
#include <cstdint>
#include <random>
#include <set>
#include <utility>

#include "coordinator/api/task_ref.h"
#include "coordinator/state/task_choice.h"

namespace tilemend {
namespace {

v1::TaskRef RefOf(const TaskKey& key, uint64_t token) {
  v1::TaskRef ref;
  ref.set_job(key.job);
  ref.set_task(key.task);
  ref.set_attempt_token(token);
  return ref;
}

// Of an attempt. Nobody is to guess it.
uint64_t NewToken() {
  thread_local std::random_device random;
  const uint64_t token = static_cast<uint64_t>(random()) << 32 | random();
  return token == 0 ? 1 : token;
}

v1::Task TaskMessage(const TaskKey& key, const Task& task, const Lease& lease) {
  v1::Task message;
  *message.mutable_ref() = RefOf(key, lease.token);
  message.mutable_cell()->set_col(task.cell.col);
  message.mutable_cell()->set_row(task.cell.row);
  message.set_stage(static_cast<v1::Stage>(task.stage));
  message.set_attempt(task.attempts);
  message.mutable_input()->set_digest(task.input);
  return message;
}

}  // namespace

std::optional<absl::Status> WorkerNews::EndOf(WorkerSync& sync) {
  const v1::SyncRequest& request = sync.request;
  v1::SyncResponse& response = sync.response;
  const auto caller = cluster_.callers.find(request.worker());
  if (caller == cluster_.callers.end() || caller->second.sequence > request.sequence()) {
    return absl::AbortedError("a newer call of this worker took over");
  }
  if (!sync.alive()) return absl::CancelledError("the worker went away");
  if (request.draining() && request.held().empty()) {
    updates_.Apply(WorkerLeft{request.worker()}).IgnoreError();
    caller->second.left = cluster_.options.clock();
    cluster_.trust.RemoveWorker(request.worker());
    cluster_.events.WorkerLeft(request.worker());
    cluster_.ShowMetrics();
    response.set_leave(true);
    return absl::OkStatus();
  }
  TellState(request, response);
  const bool news = response.start_size() > 0 || response.look_size() > 0 || response.acknowledged_size() > 0 ||
                    response.keep_size() < request.held_size();
  if (cluster_.stopping && !news) return absl::UnavailableError("the coordinator is shutting down");
  if (news || std::chrono::steady_clock::now() >= sync.deadline) return absl::OkStatus();
  return std::nullopt;
}

void WorkerNews::TellState(const v1::SyncRequest& request, v1::SyncResponse& response) {
  response.clear_start();
  response.clear_keep();
  response.clear_look();
  response.set_set_aside(cluster_.trust.WhySetAside(request.worker()));
  if (!cluster_.stopping && !request.draining()) TellToLook(request, response);
  if (!cluster_.stopping) LeaseTasks(request.worker());
  const WorkerRecord* worker = cluster_.state.FindWorker(request.worker());
  if (worker == nullptr) return;  // it was lost while it waited; its next call makes it known again
  std::set<uint64_t> known;
  for (const v1::TaskRef& ref : request.held()) {
    const Task* task = cluster_.state.FindTask(KeyOf(ref));
    if (task == nullptr || FindLease(*task, request.worker(), ref.attempt_token()) == nullptr) continue;
    known.insert(ref.attempt_token());
    *response.add_keep() = ref;
  }
  // Also what it was given before, if that answer was lost.
  for (const TaskKey& key : worker->held) {
    const Task& task = *cluster_.state.FindTask(key);
    const Lease& lease = *LeaseOf(task, request.worker());
    if (known.contains(lease.token)) continue;
    v1::Task message = TaskMessage(key, task, lease);
    message.set_trace(cluster_.jobs.at(key.job).origin.trace);
    *response.add_start() = std::move(message);
  }
}

void WorkerNews::TellToLook(const v1::SyncRequest& request, v1::SyncResponse& response) const {
  std::set<std::string> busy;
  for (const v1::FoldersSeen& seen : request.seen()) {
    if (seen.looking()) busy.insert(seen.job());
  }
  for (v1::JobFolders& folders : cluster_.trust.ToLookAt(request.worker(), busy, cluster_.options.clock())) {
    *response.add_look() = std::move(folders);
  }
}

void WorkerNews::LeaseTasks(const std::string& worker) {
  const absl::Time now = cluster_.options.clock();
  for (const TaskKey& key : ChooseTasks(cluster_.state, worker, now, cluster_.MayWorkNow())) {
    const Stage stage = cluster_.state.FindTask(key)->stage;
    const Job& job = *cluster_.state.FindJob(key.job);
    const bool starts = job.started == absl::InfiniteFuture();
    if (!updates_.Apply(TaskLeased{key, worker, NewToken(), now, now + cluster_.options.lease}).ok()) continue;
    cluster_.metrics.Started(stage);
    if (!starts) continue;
    journal_.PutJob(job, false);
    cluster_.events.JobStarted(job, cluster_.jobs.at(key.job).origin);
  }
}

}  // namespace tilemend
