// What happens to tasks while workers have them.
#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/state/coordinator_state.h"
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

}  // namespace

absl::StatusOr<Task*> CoordinatorState::LeasedTask(const TaskKey& key, const std::string& worker, uint64_t token) {
  const auto job = jobs_.find(key.job);
  if (job == jobs_.end()) return LateResult(key);
  const auto task = job->second.tasks.find(key.task);
  if (task == job->second.tasks.end() || FindLease(task->second, worker, token) == nullptr) return LateResult(key);
  return &task->second;
}

absl::StatusOr<Task*> CoordinatorState::TaskForResult(const TaskKey& key, const std::string& worker, uint64_t token) {
  const Job* known = FindJob(key.job);
  const auto place = static_cast<uint64_t>(key.task) - 1;
  const bool again =
      known != nullptr && place < known->settled_by.size() && known->settled_by[place] == MarkOf(worker, token);
  if (again) return nullptr;
  absl::StatusOr<Task*> task = LeasedTask(key, worker, token);
  if (const auto job = jobs_.find(key.job); !task.ok() && job != jobs_.end()) ++job->second.counts.refused_late;
  return task;
}

void CoordinatorState::EndLease(Job& job, Task& task, const std::string& worker) {
  if (const auto record = workers_.find(worker); record != workers_.end()) record->second.held.erase({job.id, task.id});
  if (task.leases.size() == 1) job.alone.erase({task.leases.front().since, task.id});
  std::erase_if(task.leases, [&](const Lease& lease) { return lease.worker == worker; });
  if (task.leases.size() == 1) job.alone.insert({task.leases.front().since, task.id});
}

void CoordinatorState::EndLeases(Job& job, Task& task) {
  while (!task.leases.empty()) EndLease(job, task, std::string(task.leases.back().worker));
}

void CoordinatorState::GiveUp(Job& job, Task& task, const std::string& worker, Effects& effects) {
  EndLease(job, task, worker);
  ++job.version;
  if (!task.leases.empty()) return;
  task.state = TaskState::kPending;
  --job.counts.leased;
  job.pending.Of(task.stage).insert(task.id);
  ++job.counts.pending;
  ++job.counts.retried;
  effects.retried.push_back(task.stage);
}

void CoordinatorState::Settle(Job& job, Task& task, const std::string& worker, KnownResult result, Effects& effects) {
  const Lease lease = *LeaseOf(task, worker);
  EndLeases(job, task);
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

void CoordinatorState::EnterResult(Job& job, Task& task, SettledTask settled, Effects& effects) {
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

void CoordinatorState::LoseLease(Job& job, Task& task, const std::string& worker, Effects& effects) {
  std::vector<std::string>& lost = task.lost_workers;
  if (std::find(lost.begin(), lost.end(), worker) == lost.end()) lost.push_back(worker);
  ++task.losses;
  if (static_cast<int32_t>(lost.size()) < options_.quarantine_after && task.losses < 3 * options_.quarantine_after) {
    task.returned_by.insert(worker);
    GiveUp(job, task, worker, effects);
    effects.struck.push_back({{job.id, task.id}, task.cell, task.stage, task.input, task.lost_workers});
    return;
  }
  Settle(job, task, worker, {TaskState::kQuarantined, "", Quarantined(task)}, effects);
}

absl::StatusOr<Effects> CoordinatorState::On(const TaskLeased& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.key.job));
  const auto worker = workers_.find(event.worker);
  if (worker == workers_.end()) return UnknownWorker(event.worker);
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

absl::StatusOr<Effects> CoordinatorState::On(const LeaseRenewed& event) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, LeasedTask(event.key, event.worker, event.token));
  for (Lease& lease : task->leases) {
    if (lease.worker != event.worker) continue;
    lease.deadline = std::max(lease.deadline, event.deadline);
    lease.begun |= event.begun;
  }
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const TaskCompleted& event) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, TaskForResult(event.key, event.worker, event.token));
  Effects effects;
  if (task == nullptr) return effects;
  Job& job = jobs_.at(event.key.job);
  StageTime& time = job.times[task->stage];
  ++time.tasks;
  time.total += std::max(event.time - LeaseOf(*task, event.worker)->since, absl::ZeroDuration());
  if (const auto worker = workers_.find(event.worker); worker != workers_.end()) worker->second.troubles = 0;
  if (!task->failed_by.empty()) {
    effects.contradicted.push_back(
        {event.key, task->cell, task->stage, std::move(task->failed_by), std::move(task->failure), event.worker});
  }
  Settle(job, *task, event.worker, {TaskState::kCommitted, event.output, absl::OkStatus()}, effects);
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const TaskFailed& event) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, TaskForResult(event.key, event.worker, event.token));
  Effects effects;
  if (task == nullptr) return effects;
  Job& job = jobs_.at(event.key.job);
  const bool is_refused = !event.refused.empty();
  const bool has_failed = is_refused      ? AddRefusal(options_.max_refusals, event, job, *task)
                          : event.machine ? Return(*task, event)
                                          : Fail(*task, event);
  if (has_failed) {
    const absl::Status error = is_refused ? Refused(*task, "") : event.error;
    Settle(job, *task, event.worker, {TaskState::kFailed, "", error}, effects);
  } else {
    GiveUp(job, *task, event.worker, effects);
    if (is_refused) SuspectRefused(job, event, effects);
  }
  return effects;
}

bool CoordinatorState::Fail(Task& task, const TaskFailed& event) const {
  if (!task.failed_by.empty() || !event.another) return true;
  task.failed_by = event.worker;
  task.failure = std::string(event.error.message());
  task.returned_by.insert(event.worker);
  task.not_before = event.time + options_.wait_for_another;
  return false;
}

bool CoordinatorState::Return(Task& task, const TaskFailed& event) {
  task.returned_by.insert(event.worker);
  ++task.returns;
  task.not_before = event.time + PauseAfter(task.returns);
  if (const auto worker = workers_.find(event.worker); worker != workers_.end()) {
    const int32_t troubles = ++worker->second.troubles;
    if (troubles > 1) worker->second.rests_until = event.time + PauseAfter(troubles - 1);
  }
  return task.returns >= 3 * options_.max_returns || (task.returns >= options_.max_returns && !event.another);
}

absl::Duration CoordinatorState::PauseAfter(int32_t failures) const {
  constexpr int32_t kMostDoublings = 20;  // beyond any longest pause
  return std::min(options_.longest_pause,
                  options_.first_pause * (int64_t{1} << std::min(failures - 1, kMostDoublings)));
}

absl::StatusOr<Effects> CoordinatorState::On(const TaskAbandoned& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.key.job));
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

absl::StatusOr<Effects> CoordinatorState::On(const LeaseExpired& event) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, LeasedTask(event.key, event.worker, event.token));
  Effects effects;
  Job& job = jobs_.at(event.key.job);
  if (HasBegunOthers(*task, event.worker)) {
    GiveUp(job, *task, event.worker, effects);
  } else {
    LoseLease(job, *task, event.worker, effects);
  }
  return effects;
}

bool CoordinatorState::HasBegunOthers(const Task& task, const std::string& worker) const {
  const WorkerRecord* record = FindWorker(worker);
  return record != nullptr && !LeaseOf(task, worker)->begun &&
         std::any_of(record->held.begin(), record->held.end(),
                     [&](const TaskKey& key) { return LeaseOf(*FindTask(key), worker)->begun; });
}

absl::StatusOr<Effects> CoordinatorState::TakeTasksFrom(const std::string& name, TaskLoss lose, Effects effects) {
  const auto worker = workers_.find(name);
  if (worker == workers_.end()) return UnknownWorker(name);
  const std::set<TaskKey> held = worker->second.held;
  for (const TaskKey& key : held) {
    Job& job = jobs_.at(key.job);
    (this->*lose)(job, job.tasks.at(key.task), name, effects);
  }
  workers_.erase(name);
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const WorkerLost& event) {
  const auto worker = workers_.find(event.worker);
  if (worker == workers_.end()) return UnknownWorker(event.worker);
  Effects effects;
  std::vector<TaskKey> waiting;
  for (const TaskKey& key : worker->second.held) {
    if (HasBegunOthers(*FindTask(key), event.worker)) waiting.push_back(key);
  }
  for (const TaskKey& key : waiting) {
    Job& job = jobs_.at(key.job);
    GiveUp(job, job.tasks.at(key.task), event.worker, effects);
  }
  return TakeTasksFrom(event.worker, &CoordinatorState::LoseLease, std::move(effects));
}

absl::StatusOr<Effects> CoordinatorState::On(const WorkerLeft& event) {
  return TakeTasksFrom(event.worker, &CoordinatorState::GiveUp);
}

}  // namespace tilemend
