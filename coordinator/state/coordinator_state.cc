#include "coordinator/state/coordinator_state.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "coordinator/state/lease_events.h"
#include "coordinator/state/verdicts.h"

namespace tilemend {
namespace {

// A worker that counts as lost has come back: it was silent for long, and no task ended it. Cost O(tasks).
Effects LossesTakenBack(const std::string& worker, JobTable& jobs) {
  Effects effects;
  for (const auto& [number, id] : jobs.running()) {
    for (auto& [task_id, task] : jobs.Find(id)->tasks) {
      if (std::erase(task.lost_workers, worker) == 0) continue;
      task.returned_by.erase(worker);
      effects.relieved.push_back({{id, task_id}, task.cell, task.stage, task.input, task.lost_workers});
    }
  }
  return effects;
}

// Of a job when it gets known here: above all that an earlier epoch can have reached.
uint64_t FirstVersion(const StateTables& state) { return (static_cast<uint64_t>(state.options.epoch) << 32) + 1; }

void EndJob(Job& job, JobState end, absl::Time time, StateTables& state, Effects& effects) {
  DropTasks(job, state, effects);
  job.times.clear();
  JudgeDisproved(job, end, effects);
  job.counts.pending = 0;
  job.counts.leased = 0;
  job.paused = false;
  job.ended = time;
  ++job.version;
  state.jobs.End(job, end);
}

absl::StatusOr<Effects> On(const JobCreated& event, StateTables& state) {
  if (event.job.empty()) return absl::InvalidArgumentError("a job needs an id");
  if (state.jobs.Find(event.job) != nullptr) {
    return absl::AlreadyExistsError(absl::StrCat("jobs/", event.job, ": there is one"));
  }
  if (!event.request_id.empty() && state.jobs.FindRequest(event.request_id) != nullptr) {
    return absl::AlreadyExistsError(absl::StrCat("request_id ", event.request_id, ": used before"));
  }
  Job job;
  job.id = event.job;
  job.request_id = event.request_id;
  job.number = state.jobs.last_number() + 1;
  job.version = FirstVersion(state);
  job.created = event.time;
  job.priority = event.priority;
  state.jobs.Insert(std::move(job));
  return Effects();
}

absl::StatusOr<Effects> On(const JobRestored& event, StateTables& state) {
  if (event.job.id.empty() || state.jobs.Find(event.job.id) != nullptr) {
    return absl::InvalidArgumentError(absl::StrCat("jobs/", event.job.id, ": cannot be restored"));
  }
  if (event.job.number <= state.jobs.last_number()) {
    return absl::InvalidArgumentError(
        absl::StrCat("jobs/", event.job.id, ": number ", event.job.number, " is not new"));
  }
  Job job = event.job;
  job.version = FirstVersion(state);
  state.jobs.Insert(std::move(job));
  return Effects();
}

absl::StatusOr<Effects> On(const TasksAdded& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.job));
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

absl::StatusOr<Effects> On(const WorkerSeen& event, StateTables& state) {
  if (event.worker.empty() || event.threads < 0 || event.prefetch < 0) {
    return absl::InvalidArgumentError("a worker needs an id and numbers of threads and tasks that are not negative");
  }
  Effects effects = state.workers.contains(event.worker) ? Effects() : LossesTakenBack(event.worker, state.jobs);
  WorkerRecord& worker = state.workers[event.worker];
  worker.id = event.worker;
  worker.threads = event.threads;
  worker.prefetch = event.prefetch;
  worker.draining = event.draining;
  worker.last_seen = event.time;
  return effects;
}

absl::StatusOr<Effects> On(const JobProgressed& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.job));
  if (job->progress == event.progress) return Effects();
  job->progress = event.progress;
  ++job->version;
  return Effects();
}

absl::StatusOr<Effects> On(const JobWarned& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.job));
  const bool known = std::find(job->warnings.begin(), job->warnings.end(), event.warning) != job->warnings.end();
  if (known || job->warnings.size() >= kMostWarnings) return Effects();
  job->warnings.push_back(event.warning);
  ++job->version;
  return Effects();
}

absl::StatusOr<Effects> On(const JobSteered& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.job));
  const int32_t priority = event.priority.value_or(job->priority);
  const bool paused = event.paused.value_or(job->paused);
  if (priority == job->priority && paused == job->paused) return Effects();
  job->priority = priority;
  job->paused = paused;
  ++job->version;
  return Effects();
}

absl::StatusOr<Effects> On(const JobCancelled& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.job));
  Effects effects;
  EndJob(*job, JobState::kCancelled, event.time, state, effects);
  return effects;
}

absl::StatusOr<Effects> On(const WorkerDisproved& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.job));
  return Disprove(state.options.max_refusals, event, *job);
}

absl::StatusOr<Effects> On(const JobRedone& event, StateTables& state) {
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.job));
  Effects effects;
  DropTasks(*job, state, effects);
  job->counts = job->counts.WithoutTasks();
  ++job->version;
  return effects;
}

absl::StatusOr<Effects> On(const JobFinished& event, StateTables& state) {
  if (event.state == JobState::kRunning || event.state == JobState::kCancelled) {
    return absl::InvalidArgumentError(
        absl::StrCat("jobs/", event.job, ": cannot finish as ", std::string(JobStateName(event.state))));
  }
  TILEMEND_ASSIGN_OR_RETURN(Job * job, state.jobs.FindRunning(event.job));
  const bool partial = event.state == JobState::kDone && job->counts.quarantined > 0;
  Effects effects;
  EndJob(*job, partial ? JobState::kPartial : event.state, event.time, state, effects);
  return effects;
}

absl::StatusOr<Effects> On(const JobForgotten& event, StateTables& state) {
  if (absl::Status status = state.jobs.Forget(event.job); !status.ok()) return status;
  return Effects();
}

}  // namespace

absl::StatusOr<Effects> CoordinatorState::Apply(const Event& event) {
  absl::StatusOr<Effects> effects = std::visit([this](const auto& e) { return On(e, tables_); }, event);
  if (!effects.ok()) return effects;
  RevokeOfSetAside(tables_.jobs, *effects);
  KeepDisprovedSuspected(tables_.jobs, *effects);
  return effects;
}

const WorkerRecord* CoordinatorState::FindWorker(const std::string& worker) const {
  const auto it = workers().find(worker);
  return it == workers().end() ? nullptr : &it->second;
}

}  // namespace tilemend
