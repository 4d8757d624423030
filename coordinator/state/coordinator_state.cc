#include "coordinator/state/coordinator_state.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

std::string Describe(const Task& task) {
  return absl::StrCat("cell (", task.cell.col, ", ", task.cell.row, "), stage ", std::string(StageName(task.stage)));
}

absl::Status JobNotFound(const std::string& job) {
  return WithErrorInfo(absl::NotFoundError(absl::StrCat("jobs/", job, ": no such job")),
                       {"JOB_NOT_FOUND", {{"job", job}}});
}

absl::Status JobOver(const Job& job) {
  const std::string state(JobStateName(job.state));
  return WithErrorInfo(absl::FailedPreconditionError(absl::StrCat("jobs/", job.id, ": the job is over (", state, ")")),
                       {"JOB_OVER", {{"job", job.id}, {"state", state}}});
}

absl::Status LateResult(const TaskKey& key, uint64_t token) {
  return WithErrorInfo(absl::FailedPreconditionError(absl::StrCat("jobs/", key.job, " task ", key.task, ": attempt ",
                                                                  token, " was given up before its result came")),
                       {"LATE_RESULT", {{"job", key.job}, {"task", absl::StrCat(key.task)}}});
}

absl::Status Quarantined(const Task& task) {
  const std::string text =
      absl::StrCat(Describe(task), ": quarantined after ", task.lost_workers.size(),
                   " workers were lost while they had it (", absl::StrJoin(task.lost_workers, ", "), ")");
  return WithErrorInfo(absl::AbortedError(text), {"QUARANTINED",
                                                  {{"cell", absl::StrCat(task.cell.col, ",", task.cell.row)},
                                                   {"stage", std::string(StageName(task.stage))}}});
}

}  // namespace

std::string_view JobStateName(JobState state) {
  switch (state) {
    case JobState::kRunning:
      return "running";
    case JobState::kDone:
      return "done";
    case JobState::kPartial:
      return "partial";
    case JobState::kFailed:
      return "failed";
    case JobState::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

CoordinatorState::CoordinatorState(const StateOptions& options)
    : options_(options), last_token_(static_cast<uint64_t>(options.epoch) << 32) {}

absl::StatusOr<Effects> CoordinatorState::Apply(const Event& event) {
  return std::visit([this](const auto& e) { return On(e); }, event);
}

const Job* CoordinatorState::FindJob(const std::string& job) const {
  const auto it = jobs_.find(job);
  return it == jobs_.end() ? nullptr : &it->second;
}

const Job* CoordinatorState::FindRequest(const std::string& request_id) const {
  const auto it = requests_.find(request_id);
  return it == requests_.end() ? nullptr : FindJob(it->second);
}

const Task* CoordinatorState::FindTask(const TaskKey& key) const {
  const Job* job = FindJob(key.job);
  if (job == nullptr) return nullptr;
  const auto it = job->tasks.find(key.task);
  return it == job->tasks.end() ? nullptr : &it->second;
}

const WorkerRecord* CoordinatorState::FindWorker(const std::string& worker) const {
  const auto it = workers_.find(worker);
  return it == workers_.end() ? nullptr : &it->second;
}

bool CoordinatorState::IsLastChance(const Task& task) const {
  return static_cast<int32_t>(task.lost_workers.size()) + 1 >= options_.quarantine_after &&
         options_.quarantine_after > 1;
}

bool CoordinatorState::HasAnother(const std::string& worker, const Job& job, const Task& task,
                                  const MayWork& may) const {
  return std::any_of(workers_.begin(), workers_.end(), [&](const auto& entry) {
    const auto& [id, other] = entry;
    return id != worker && !other.draining && other.threads > 0 && !task.returned_by.contains(id) && may(id, job.id);
  });
}

std::vector<TaskKey> CoordinatorState::ChooseTasks(const std::string& worker, const MayWork& may) const {
  const WorkerRecord* record = FindWorker(worker);
  std::vector<TaskKey> chosen;
  if (record == nullptr || record->draining) return chosen;
  for (const TaskKey& key : record->held) {
    if (IsLastChance(*FindTask(key))) return chosen;
  }
  const size_t free = record->threads - std::min<size_t>(record->threads, record->held.size());
  for (const auto& [number, id] : running_) {
    const Job& job = jobs_.at(id);
    if (job.pending.empty() || !may(worker, id)) continue;
    for (const int64_t pending : job.pending) {
      if (chosen.size() >= free) return chosen;
      const Task& task = job.tasks.at(pending);
      if (task.refused.contains(worker)) continue;
      if (task.returned_by.contains(worker) && HasAnother(worker, job, task, may)) continue;
      if (IsLastChance(task)) {
        // Alone or not at all. A worker that holds others takes nothing more before it, so that it comes to its turn.
        if (record->held.empty() && chosen.empty()) chosen.push_back({id, pending});
        return chosen;
      }
      chosen.push_back({id, pending});
    }
  }
  return chosen;
}

std::vector<Event> CoordinatorState::Overdue(absl::Time now, absl::Duration silence) const {
  std::vector<Event> events;
  for (const auto& [id, worker] : workers_) {
    if (worker.last_seen + silence < now) {
      events.push_back(WorkerLost{id});
      continue;
    }
    for (const TaskKey& key : worker.held) {
      const Task* task = FindTask(key);
      const bool too_long = task->leased_at + options_.longest_attempt < now;
      if (task->deadline < now || too_long) events.push_back(LeaseExpired{key, task->token});
    }
  }
  return events;
}

absl::StatusOr<Job*> CoordinatorState::RunningJob(const std::string& id) {
  const auto it = jobs_.find(id);
  if (it == jobs_.end()) return JobNotFound(id);
  if (IsOver(it->second.state)) return JobOver(it->second);
  return &it->second;
}

absl::StatusOr<Task*> CoordinatorState::LeasedTask(const TaskKey& key, uint64_t token) {
  const auto job = jobs_.find(key.job);
  if (job == jobs_.end()) return JobNotFound(key.job);
  const auto task = job->second.tasks.find(key.task);
  if (task == job->second.tasks.end() || task->second.state != TaskState::kLeased || task->second.token != token) {
    return LateResult(key, token);
  }
  return &task->second;
}

absl::StatusOr<Task*> CoordinatorState::TaskForResult(const TaskKey& key, uint64_t token) {
  const Task* known = FindTask(key);
  if (known != nullptr && IsSettled(known->state) && known->state != TaskState::kQuarantined && known->token == token) {
    return nullptr;
  }
  absl::StatusOr<Task*> task = LeasedTask(key, token);
  if (const auto job = jobs_.find(key.job); !task.ok() && job != jobs_.end()) ++job->second.counts.refused_late;
  return task;
}

void CoordinatorState::EndLease(Job& job, Task& task) {
  --job.counts.leased;
  if (const auto worker = workers_.find(task.worker); worker != workers_.end()) {
    worker->second.held.erase({job.id, task.id});
  }
}

void CoordinatorState::BackToPending(Job& job, Task& task, Effects& effects) {
  EndLease(job, task);
  task.state = TaskState::kPending;
  task.token = 0;
  task.worker.clear();
  job.pending.insert(task.id);
  ++job.counts.pending;
  ++job.counts.retried;
  ++job.version;
  effects.retried.push_back(task.stage);
}

void CoordinatorState::Settle(Job& job, Task& task, KnownResult result, Effects& effects) {
  EndLease(job, task);
  EnterResult(job, task, std::move(result), false, effects);
}

void CoordinatorState::EnterResult(Job& job, Task& task, KnownResult result, bool known, Effects& effects) {
  task.state = result.state;
  int64_t& count = task.state == TaskState::kCommitted ? job.counts.committed
                   : task.state == TaskState::kFailed  ? job.counts.failed
                                                       : job.counts.quarantined;
  ++count;
  ++job.version;
  effects.settled.push_back({.key = {job.id, task.id},
                             .cell = task.cell,
                             .stage = task.stage,
                             .input = std::exchange(task.input, {}),
                             .state = task.state,
                             .output = std::move(result.output),
                             .error = std::move(result.error),
                             .known = known,
                             .leased_at = task.leased_at});
}

void CoordinatorState::LoseLease(Job& job, Task& task, Effects& effects) {
  std::vector<std::string>& lost = task.lost_workers;
  if (std::find(lost.begin(), lost.end(), task.worker) == lost.end()) lost.push_back(task.worker);
  ++task.losses;
  if (static_cast<int32_t>(lost.size()) < options_.quarantine_after && task.losses < 3 * options_.quarantine_after) {
    task.returned_by.insert(task.worker);
    BackToPending(job, task, effects);
    effects.struck.push_back({{job.id, task.id}, task.cell, task.stage, task.input, task.lost_workers});
    return;
  }
  Settle(job, task, {TaskState::kQuarantined, "", Quarantined(task)}, effects);
}

void CoordinatorState::EndJob(Job& job, JobState state, absl::Time time) {
  for (auto& [id, task] : job.tasks) {
    if (task.state == TaskState::kLeased) EndLease(job, task);
  }
  job.tasks.clear();
  job.pending.clear();
  job.counts.pending = 0;
  job.state = state;
  job.ended = time;
  ++job.version;
  running_.erase(job.number);
}

absl::StatusOr<Effects> CoordinatorState::On(const JobCreated& event) {
  if (event.job.empty()) return absl::InvalidArgumentError("a job needs an id");
  if (jobs_.contains(event.job)) return absl::AlreadyExistsError(absl::StrCat("jobs/", event.job, ": there is one"));
  if (!event.request_id.empty() && requests_.contains(event.request_id)) {
    return absl::AlreadyExistsError(absl::StrCat("request_id ", event.request_id, ": used before"));
  }
  Job job;
  job.id = event.job;
  job.request_id = event.request_id;
  job.number = job_numbers_.empty() ? 1 : job_numbers_.rbegin()->first + 1;
  job.created = event.time;
  job.version = FirstVersion();
  Insert(std::move(job));
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const JobRestored& event) {
  if (event.job.id.empty() || jobs_.contains(event.job.id)) {
    return absl::InvalidArgumentError(absl::StrCat("jobs/", event.job.id, ": cannot be restored"));
  }
  if (!job_numbers_.empty() && event.job.number <= job_numbers_.rbegin()->first) {
    return absl::InvalidArgumentError(
        absl::StrCat("jobs/", event.job.id, ": number ", event.job.number, " is not new"));
  }
  Job job = event.job;
  job.version = FirstVersion();
  Insert(std::move(job));
  return Effects();
}

void CoordinatorState::Insert(Job job) {
  job_numbers_[job.number] = job.id;
  if (!IsOver(job.state)) running_[job.number] = job.id;
  if (!job.request_id.empty()) requests_[job.request_id] = job.id;
  jobs_[job.id] = std::move(job);
}

absl::StatusOr<Effects> CoordinatorState::On(const TasksAdded& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  Effects effects;
  for (const TaskSpec& spec : event.tasks) {
    const int64_t id = ++job->counts.added;
    Task& task = job->tasks[id];
    task.id = id;
    task.cell = spec.cell;
    task.stage = spec.stage;
    task.input = spec.input;
    task.lost_workers = spec.lost_workers;
    if (spec.known) {
      EnterResult(*job, task, *spec.known, true, effects);
      continue;
    }
    job->pending.insert(id);
    ++job->counts.pending;
  }
  ++job->version;
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const WorkerSeen& event) {
  if (event.worker.empty() || event.threads < 0) {
    return absl::InvalidArgumentError("a worker needs an id and a number of threads that is not negative");
  }
  WorkerRecord& worker = workers_[event.worker];
  worker.id = event.worker;
  worker.threads = event.threads;
  worker.draining = event.draining;
  worker.last_seen = event.time;
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const TaskLeased& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.key.job));
  const auto worker = workers_.find(event.worker);
  if (worker == workers_.end()) return absl::InvalidArgumentError(absl::StrCat("worker ", event.worker, ": unknown"));
  const auto task = job->tasks.find(event.key.task);
  if (task == job->tasks.end() || task->second.state != TaskState::kPending) {
    return absl::InvalidArgumentError(absl::StrCat("jobs/", job->id, " task ", event.key.task, ": not pending"));
  }
  if (event.token <= last_token_) {
    return absl::InvalidArgumentError(absl::StrCat("attempt token ", event.token, ": not above ", last_token_));
  }
  last_token_ = event.token;
  Task& t = task->second;
  t.state = TaskState::kLeased;
  ++t.attempts;
  t.token = event.token;
  t.worker = event.worker;
  t.leased_at = event.time;
  t.deadline = event.deadline;
  worker->second.held.insert(event.key);
  job->pending.erase(t.id);
  --job->counts.pending;
  ++job->counts.leased;
  ++job->version;
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const LeaseRenewed& event) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, LeasedTask(event.key, event.token));
  task->deadline = std::max(task->deadline, event.deadline);
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const TaskCompleted& event) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, TaskForResult(event.key, event.token));
  Effects effects;
  if (task != nullptr)
    Settle(jobs_.at(event.key.job), *task, {TaskState::kCommitted, event.output, absl::OkStatus()}, effects);
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const TaskFailed& event) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, TaskForResult(event.key, event.token));
  Effects effects;
  if (task == nullptr) return effects;
  Job& job = jobs_.at(event.key.job);
  const bool again =
      event.refused.empty() ? event.machine && ++task->returns < options_.max_returns : !Refuse(*task, event.refused);
  if (again) {
    if (event.refused.empty()) task->returned_by.insert(task->worker);
    BackToPending(job, *task, effects);
  } else {
    Settle(job, *task, {TaskState::kFailed, "", event.error}, effects);
  }
  return effects;
}

bool CoordinatorState::Refuse(Task& task, const std::string& digest) const {
  const bool agreed = std::any_of(task.refused.begin(), task.refused.end(), [&](const auto& refused) {
    return refused.first != task.worker && refused.second == digest;
  });
  task.refused[task.worker] = digest;
  return agreed || static_cast<int32_t>(task.refused.size()) >= options_.max_refusals;
}

absl::StatusOr<Effects> CoordinatorState::On(const LeaseExpired& event) {
  TILEMEND_ASSIGN_OR_RETURN(Task * task, LeasedTask(event.key, event.token));
  Effects effects;
  LoseLease(jobs_.at(event.key.job), *task, effects);
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const WorkerLost& event) {
  const auto worker = workers_.find(event.worker);
  if (worker == workers_.end()) return absl::InvalidArgumentError(absl::StrCat("worker ", event.worker, ": unknown"));
  Effects effects;
  const std::set<TaskKey> held = worker->second.held;
  for (const TaskKey& key : held) {
    Job& job = jobs_.at(key.job);
    LoseLease(job, job.tasks.at(key.task), effects);
  }
  workers_.erase(event.worker);
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const WorkerLeft& event) {
  const auto worker = workers_.find(event.worker);
  if (worker == workers_.end()) return absl::InvalidArgumentError(absl::StrCat("worker ", event.worker, ": unknown"));
  Effects effects;
  const std::set<TaskKey> held = worker->second.held;
  for (const TaskKey& key : held) {
    Job& job = jobs_.at(key.job);
    BackToPending(job, job.tasks.at(key.task), effects);
  }
  workers_.erase(event.worker);
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const JobProgressed& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  if (job->progress == event.progress) return Effects();
  job->progress = event.progress;
  ++job->version;
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const JobWarned& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  const bool known = std::find(job->warnings.begin(), job->warnings.end(), event.warning) != job->warnings.end();
  if (known || job->warnings.size() >= kMostWarnings) return Effects();
  job->warnings.push_back(event.warning);
  ++job->version;
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const JobCancelled& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  EndJob(*job, JobState::kCancelled, event.time);
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const JobFinished& event) {
  if (event.state == JobState::kRunning || event.state == JobState::kCancelled) {
    return absl::InvalidArgumentError(
        absl::StrCat("jobs/", event.job, ": cannot finish as ", std::string(JobStateName(event.state))));
  }
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  const bool partial = event.state == JobState::kDone && job->counts.quarantined > 0;
  EndJob(*job, partial ? JobState::kPartial : event.state, event.time);
  return Effects();
}

}  // namespace tilemend
