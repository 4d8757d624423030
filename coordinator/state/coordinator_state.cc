#include "coordinator/state/coordinator_state.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/util/error_info.h"
#include "common/util/status_macros.h"
#include "coordinator/state/verdicts.h"

namespace tilemend {
namespace {

absl::Status JobNotFound(const std::string& job) {
  return WithErrorInfo(absl::NotFoundError(absl::StrCat("jobs/", job, ": no such job")),
                       {"JOB_NOT_FOUND", {{"job", job}}});
}

absl::Status JobOver(const Job& job) {
  const std::string state(JobStateName(job.state));
  return WithErrorInfo(absl::FailedPreconditionError(absl::StrCat("jobs/", job.id, ": the job is over (", state, ")")),
                       {"JOB_OVER", {{"job", job.id}, {"state", state}}});
}

// A worker that counts as lost has come back: it was silent for long, and no task ended it. Cost O(tasks).
Effects LossesTakenBack(const std::string& worker, const std::map<int64_t, std::string>& running,
                        std::map<std::string, Job>& jobs) {
  Effects effects;
  for (const auto& [number, id] : running) {
    for (auto& [task_id, task] : jobs.at(id).tasks) {
      if (std::erase(task.lost_workers, worker) == 0) continue;
      task.returned_by.erase(worker);
      effects.relieved.push_back({{id, task_id}, task.cell, task.stage, task.input, task.lost_workers});
    }
  }
  return effects;
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

CoordinatorState::CoordinatorState(const StateOptions& options) : options_(options) {}

absl::StatusOr<Effects> CoordinatorState::Apply(const Event& event) {
  absl::StatusOr<Effects> effects = std::visit([this](const auto& e) { return On(e); }, event);
  if (!effects.ok()) return effects;
  RevokeOfConvicted(running_, jobs_, *effects);
  return effects;
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

absl::StatusOr<Job*> CoordinatorState::RunningJob(const std::string& id) {
  const auto it = jobs_.find(id);
  if (it == jobs_.end()) return JobNotFound(id);
  if (IsOver(it->second.state)) return JobOver(it->second);
  return &it->second;
}

void CoordinatorState::DropTasks(Job& job, Effects& effects) {
  for (auto& [id, task] : job.tasks) {
    EndLeases(job, task);
  }
  ForgetRefusals(job, effects);
  job.tasks.clear();
  std::vector<uint64_t>().swap(job.settled_by);
  job.pending = {};
  job.given = {};
}

void CoordinatorState::EndJob(Job& job, JobState state, absl::Time time, Effects& effects) {
  DropTasks(job, effects);
  job.times.clear();
  JudgeDisproved(job, state, effects);
  job.counts.pending = 0;
  job.counts.leased = 0;
  job.state = state;
  job.paused = false;
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
  job.number = last_number_ + 1;
  job.created = event.time;
  job.priority = event.priority;
  Insert(std::move(job));
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const JobRestored& event) {
  if (event.job.id.empty() || jobs_.contains(event.job.id)) {
    return absl::InvalidArgumentError(absl::StrCat("jobs/", event.job.id, ": cannot be restored"));
  }
  if (event.job.number <= last_number_) {
    return absl::InvalidArgumentError(
        absl::StrCat("jobs/", event.job.id, ": number ", event.job.number, " is not new"));
  }
  Job job = event.job;
  Insert(std::move(job));
  return Effects();
}

void CoordinatorState::Insert(Job job) {
  job.version = FirstVersion();
  last_number_ = job.number;
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
    task.returned_by.insert(spec.avoid.begin(), spec.avoid.end());
    if (spec.known) {
      SettledTask settled = SettledAs(*spec.known);
      settled.known = true;
      EnterResult(*job, task, std::move(settled), effects);
      continue;
    }
    job->pending.Of(task.stage).insert(id);
    ++job->counts.pending;
  }
  ++job->version;
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const WorkerSeen& event) {
  if (event.worker.empty() || event.threads < 0 || event.prefetch < 0) {
    return absl::InvalidArgumentError("a worker needs an id and numbers of threads and tasks that are not negative");
  }
  Effects effects = workers_.contains(event.worker) ? Effects() : LossesTakenBack(event.worker, running_, jobs_);
  WorkerRecord& worker = workers_[event.worker];
  worker.id = event.worker;
  worker.threads = event.threads;
  worker.prefetch = event.prefetch;
  worker.draining = event.draining;
  worker.last_seen = event.time;
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

absl::StatusOr<Effects> CoordinatorState::On(const JobSteered& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  const int32_t priority = event.priority.value_or(job->priority);
  const bool paused = event.paused.value_or(job->paused);
  if (priority == job->priority && paused == job->paused) return Effects();
  job->priority = priority;
  job->paused = paused;
  ++job->version;
  return Effects();
}

absl::StatusOr<Effects> CoordinatorState::On(const JobCancelled& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  Effects effects;
  EndJob(*job, JobState::kCancelled, event.time, effects);
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const WorkerDisproved& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  return Disprove(options_.max_refusals, event, *job);
}

absl::StatusOr<Effects> CoordinatorState::On(const JobRedone& event) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  Effects effects;
  DropTasks(*job, effects);
  job->counts = job->counts.WithoutTasks();
  ++job->version;
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const JobFinished& event) {
  if (event.state == JobState::kRunning || event.state == JobState::kCancelled) {
    return absl::InvalidArgumentError(
        absl::StrCat("jobs/", event.job, ": cannot finish as ", std::string(JobStateName(event.state))));
  }
  TILEMEND_ASSIGN_OR_RETURN(Job * job, RunningJob(event.job));
  const bool partial = event.state == JobState::kDone && job->counts.quarantined > 0;
  Effects effects;
  EndJob(*job, partial ? JobState::kPartial : event.state, event.time, effects);
  return effects;
}

absl::StatusOr<Effects> CoordinatorState::On(const JobForgotten& event) {
  const auto job = jobs_.find(event.job);
  if (job == jobs_.end()) return JobNotFound(event.job);
  if (!IsOver(job->second.state)) return absl::InvalidArgumentError(absl::StrCat("jobs/", event.job, ": not over"));
  job_numbers_.erase(job->second.number);
  if (!job->second.request_id.empty()) requests_.erase(job->second.request_id);
  jobs_.erase(job);
  return Effects();
}

}  // namespace tilemend
