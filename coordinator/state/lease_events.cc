#include "coordinator/state/lease_events.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/state/verdicts.h"

namespace tilemend {
namespace {

std::string Describe(const Task& task) {
  return absl::StrCat("cell (", task.cell.col, ", ", task.cell.row, "), stage ", std::string(StageName(task.stage)));
}

absl::Status LateResult(const TaskKey& key) {
  return WithErrorInfo(
      absl::FailedPreconditionError(
          absl::StrCat("jobs/", key.job, " task ", key.task, ": that attempt was given up, or is of another worker")),
      {"LATE_RESULT", {{"job", key.job}, {"task", absl::StrCat(key.task)}}});
}

absl::Status UnknownWorker(const std::string& worker) {
  return absl::InvalidArgumentError(absl::StrCat("worker ", worker, ": unknown"));
}

absl::Status Quarantined(const Task& task) {
  const std::string text =
      absl::StrCat(Describe(task), ": quarantined after ", task.lost_workers.size(),
                   " workers were lost while they had it (", absl::StrJoin(task.lost_workers, ", "), ")");
  return WithErrorInfo(absl::AbortedError(text), {"QUARANTINED",
                                                  {{"cell", absl::StrCat(task.cell.col, ",", task.cell.row)},
                                                   {"stage", std::string(StageName(task.stage))}}});
}

// Of a task that has failed by its refusals.
absl::Status Refused(const Task& task, const std::string& ending) {
  const std::string reasons = absl::StrJoin(
      task.refused, "; ", [](std::string* out, const auto& refused) { absl::StrAppend(out, refused.second.reason); });
  return WithErrorInfo(absl::InternalError(absl::StrCat(reasons, ending)), {"RESULT_REFUSED", {}});
}

// The task of which that attempt is a lease; LATE_RESULT (not counted here) if it is none.
absl::StatusOr<Task*> LeasedTask(const TaskKey& key, const std::string& worker, uint64_t token, JobTable& jobs) {
  Job* job = jobs.Find(key.job);
  if (job == nullptr) return LateResult(key);
  const auto task = job->tasks.find(key.task);
  if (task == job->tasks.end() || FindLease(task->second, worker, token) == nullptr) return LateResult(key);
  return &task->second;
}

// For results: as LeasedTask, but null for a repeated report of the attempt that settled the task, and counting.
absl::StatusOr<Task*> TaskForResult(const TaskKey& key, const std::string& worker, uint64_t token, JobTable& jobs) {
  Job* job = jobs.Find(key.job);
  const auto place = static_cast<uint64_t>(key.task) - 1;
  const bool again =
      job != nullptr && place < job->settled_by.size() && job->settled_by[place] == MarkOf(worker, token);
  if (again) return nullptr;
  absl::StatusOr<Task*> task = LeasedTask(key, worker, token, jobs);
  if (!task.ok() && job != nullptr) ++job->counts.refused_late;
  return task;
}

void EndLease(Job& job, Task& task, const std::string& worker, StateTables& state) {
  if (const auto record = state.workers.find(worker); record != state.workers.end())
    record->second.held.erase({job.id, task.id});
  if (task.leases.size() == 1) job.alone.erase({task.leases.front().since, task.id});
  std::erase_if(task.leases, [&](const Lease& lease) { return lease.worker == worker; });
  if (task.leases.size() == 1) job.alone.insert({task.leases.front().since, task.id});
}

void EndLeases(Job& job, Task& task, StateTables& state) {
  while (!task.leases.empty()) EndLease(job, task, std::string(task.leases.back().worker), state);
}

// Of an attempt of `worker`, which gave no result. The task is pending again unless there is another attempt.
void GiveUp(Job& job, Task& task, const std::string& worker, StateTables& state, Effects& effects) {
  EndLease(job, task, worker, state);
  ++job.version;
  if (!task.leases.empty()) return;
  task.state = TaskState::kPending;
  --job.counts.leased;
  job.pending.Of(task.stage).insert(task.id);
  ++job.counts.pending;
  ++job.counts.retried;
  effects.retried.push_back(task.stage);
}

// Of a leased task; `result` says how, `worker` whose attempt it was.
void Settle(Job& job, Task& task, const std::string& worker, KnownResult result, StateTables& state, Effects& effects) {
  const Lease lease = *LeaseOf(task, worker);
  EndLeases(job, task, state);
  --job.counts.leased;
  if (result.state != TaskState::kQuarantined) {
    job.settled_by.resize(std::max<size_t>(job.settled_by.size(), static_cast<size_t>(task.id)));
    job.settled_by[static_cast<size_t>(task.id) - 1] = MarkOf(worker, lease.token);
  }
  if (result.state == TaskState::kCommitted) result.worker = worker;
  SettledTask settled = SettledAs(std::move(result));
  settled.leased_at = lease.since;
  EnterResult(job, task, std::move(settled), effects);
}

void LoseLease(Job& job, Task& task, const std::string& worker, StateTables& state, Effects& effects) {
  std::vector<std::string>& lost = task.lost_workers;
  if (std::find(lost.begin(), lost.end(), worker) == lost.end()) lost.push_back(worker);
  ++task.losses;
  if (static_cast<int32_t>(lost.size()) < state.options.quarantine_after &&
      task.losses < 3 * state.options.quarantine_after) {
    task.returned_by.insert(worker);
    GiveUp(job, task, worker, state, effects);
    effects.struck.push_back({{job.id, task.id}, task.cell, task.stage, task.input, task.lost_workers});
    return;
  }
  Settle(job, task, worker, {TaskState::kQuarantined, "", Quarantined(task)}, state, effects);
}

absl::Duration PauseAfter(int32_t failures, const StateOptions& options) {
  constexpr int32_t kMostDoublings = 20;  // beyond any longest pause
  return std::min(options.longest_pause, options.first_pause * (int64_t{1} << std::min(failures - 1, kMostDoublings)));
}

// What a machine error means for the task and the worker; whether the task has failed by it.
bool Return(Task& task, const TaskFailed& event, StateTables& state) {
  task.returned_by.insert(event.worker);
  ++task.returns;
  task.not_before = event.time + PauseAfter(task.returns, state.options);
  // All that fails while it rests is one trouble: a cut of the network ends each of its tasks.
  if (const auto worker = state.workers.find(event.worker);
      worker != state.workers.end() && event.time >= worker->second.rests_until) {
    const int32_t troubles = ++worker->second.troubles;
    if (troubles > 1) worker->second.rests_until = event.time + PauseAfter(troubles - 1, state.options);
  }
  return task.returns >= 3 * state.options.max_returns || (task.returns >= state.options.max_returns && !event.another);
}

// Whether the task has failed by an error of its own: one worker's word is not enough where there is another.
bool Fail(Task& task, const TaskFailed& event, const StateOptions& options) {
  if (!task.failed_by.empty() || !event.another) return true;
  task.failed_by = event.worker;
  task.failure = std::string(event.error.message());
  task.returned_by.insert(event.worker);
  task.not_before = event.time + options.wait_for_another;
  return false;
}

// Whether the worker told that it is at others of the tasks that it holds, and not at this one.
bool HasBegunOthers(const Task& task, const std::string& worker, const StateTables& state) {
  const auto record = state.workers.find(worker);
  return record != state.workers.end() && !LeaseOf(task, worker)->begun &&
         std::any_of(record->second.held.begin(), record->second.held.end(),
                     [&](const TaskKey& key) { return LeaseOf(*state.jobs.FindTask(key), worker)->begun; });
}

using TaskLoss = void(Job& job, Task& task, const std::string& worker, StateTables& state, Effects& effects);
// Ends the worker, and each of its attempts with `lose`.
absl::StatusOr<Effects> TakeTasksFrom(const std::string& name, TaskLoss* lose, StateTables& state,
                                      Effects effects = {}) {
  const auto worker = state.workers.find(name);
  if (worker == state.workers.end()) return UnknownWorker(name);
  const std::set<TaskKey> held = worker->second.held;
  for (const TaskKey& key : held) {
    Job& job = *state.jobs.Find(key.job);
    lose(job, job.tasks.at(key.task), name, state, effects);
  }
  state.workers.erase(name);
  return effects;
}

}  // namespace

void EnterResult(Job& job, Task& task, SettledTask settled, Effects& effects) {
  int64_t& count = settled.state == TaskState::kCommitted ? job.counts.committed
                   : settled.state == TaskState::kFailed  ? job.counts.failed
                                                          : job.counts.quarantined;
  ++count;
  ++job.version;
  task.state = settled.state;
  if (!settled.worker.empty()) job.given.Put(task.id, settled.worker);
  JudgeRefusals(job, task, effects);
  settled.key = {job.id, task.id};
  settled.cell = task.cell;
  settled.stage = task.stage;
  settled.input = std::move(task.input);
  effects.settled.push_back(std::move(settled));
  job.tasks.erase(effects.settled.back().key.task);
}

void DropTasks(Job& job, StateTables& state, Effects& effects) {
  for (auto& [id, task] : job.tasks) {
    EndLeases(job, task, state);
  }
  ForgetRefusals(job, effects);
  job.tasks.clear();
  std::vector<uint64_t>().swap(job.settled_by);
  job.pending = {};
  job.given = {};
}

absl::StatusOr<Effects> On(const TaskLeased& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.key.job));
  const auto worker = state.workers.find(event.worker);
  if (worker == state.workers.end()) return UnknownWorker(event.worker);
  const auto found = job->tasks.find(event.key.task);
  const bool is_second =
      found != job->tasks.end() && found->second.leases.size() == 1 && LeaseOf(found->second, event.worker) == nullptr;
  if (found == job->tasks.end() || (found->second.state != TaskState::kPending && !is_second)) {
    return absl::InvalidArgumentError(absl::StrCat("jobs/", job->id, " task ", event.key.task, ": not pending"));
  }
  if (event.token == 0) return absl::InvalidArgumentError("an attempt needs a token that is not 0");
  job->started = std::min(job->started, event.time);
  Task& task = found->second;
  ++task.attempts;
  if (is_second) {
    ++job->counts.doubled;
    job->alone.erase({task.leases.front().since, task.id});
  } else {
    task.state = TaskState::kLeased;
    job->pending.Of(task.stage).erase(task.id);
    --job->counts.pending;
    ++job->counts.leased;
    job->alone.insert({event.time, task.id});
  }
  task.leases.push_back({event.token, event.worker, event.time, event.deadline});
  worker->second.held.insert(event.key);
  ++job->version;
  return Effects();
}

absl::StatusOr<Effects> On(const LeaseRenewed& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, LeasedTask(event.key, event.worker, event.token, state.jobs));
  for (Lease& lease : task->leases) {
    if (lease.worker != event.worker) continue;
    lease.deadline = std::max(lease.deadline, event.deadline);
    lease.begun |= event.begun;
  }
  return Effects();
}

absl::StatusOr<Effects> On(const TaskCompleted& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, TaskForResult(event.key, event.worker, event.token, state.jobs));
  Effects effects;
  if (task == nullptr) return effects;
  Job& job = *state.jobs.Find(event.key.job);
  StageTime& time = job.times[task->stage];
  ++time.tasks;
  time.total += std::max(event.time - LeaseOf(*task, event.worker)->since, absl::ZeroDuration());
  if (const auto worker = state.workers.find(event.worker); worker != state.workers.end()) worker->second.troubles = 0;
  if (!task->failed_by.empty()) {
    effects.contradicted.push_back(
        {event.key, task->cell, task->stage, std::move(task->failed_by), std::move(task->failure), event.worker});
  }
  Settle(job, *task, event.worker, {TaskState::kCommitted, event.output, absl::OkStatus()}, state, effects);
  return effects;
}

absl::StatusOr<Effects> On(const TaskFailed& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, TaskForResult(event.key, event.worker, event.token, state.jobs));
  Effects effects;
  if (task == nullptr) return effects;
  Job& job = *state.jobs.Find(event.key.job);
  const bool is_refused = !event.refused.empty();
  const bool has_failed = is_refused      ? AddRefusal(state.options.max_refusals, event, job, *task)
                          : event.machine ? Return(*task, event, state)
                                          : Fail(*task, event, state.options);
  if (has_failed) {
    const absl::Status error = is_refused ? Refused(*task, "") : event.error;
    Settle(job, *task, event.worker, {TaskState::kFailed, "", error}, state, effects);
  } else {
    GiveUp(job, *task, event.worker, state, effects);
    if (is_refused) SuspectRefused(job, event, effects);
  }
  return effects;
}

absl::StatusOr<Effects> On(const TaskAbandoned& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.key.job));
  const auto found = job->tasks.find(event.key.task);
  if (found == job->tasks.end() || found->second.state != TaskState::kPending || found->second.refused.empty()) {
    return absl::InvalidArgumentError(
        absl::StrCat("jobs/", job->id, " task ", event.key.task, ": nothing was refused"));
  }
  Effects effects;
  job->pending.Of(found->second.stage).erase(event.key.task);
  --job->counts.pending;
  const absl::Status error = Refused(found->second, "; there is no other worker to try it");
  EnterResult(*job, found->second, SettledAs({TaskState::kFailed, "", error}), effects);
  return effects;
}

absl::StatusOr<Effects> On(const LeaseExpired& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, LeasedTask(event.key, event.worker, event.token, state.jobs));
  Effects effects;
  Job& job = *state.jobs.Find(event.key.job);
  if (HasBegunOthers(*task, event.worker, state)) {
    GiveUp(job, *task, event.worker, state, effects);
  } else {
    LoseLease(job, *task, event.worker, state, effects);
  }
  return effects;
}

absl::StatusOr<Effects> On(const WorkerLost& event, StateTables& state) {
  const auto worker = state.workers.find(event.worker);
  if (worker == state.workers.end()) return UnknownWorker(event.worker);
  Effects effects;
  std::vector<TaskKey> waiting;
  for (const TaskKey& key : worker->second.held) {
    if (HasBegunOthers(*state.jobs.FindTask(key), event.worker, state)) waiting.push_back(key);
  }
  for (const TaskKey& key : waiting) {
    Job& job = *state.jobs.Find(key.job);
    GiveUp(job, job.tasks.at(key.task), event.worker, state, effects);
  }
  return TakeTasksFrom(event.worker, LoseLease, state, std::move(effects));
}

absl::StatusOr<Effects> On(const WorkerLeft& event, StateTables& state) {
  return TakeTasksFrom(event.worker, GiveUp, state);
}

}  // namespace tilemend
