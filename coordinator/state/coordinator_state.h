// The coordinator's state: jobs, their tasks and the workers that hold them, changed by events alone.
//
// Guarantees
//  - Execution at least once, commit exactly once: a result counts only if it comes from the worker and carries the
//    token of a present lease of the task. A second report of the attempt that settled a task is accepted and changes
//    nothing (its answer was lost); any other late result is refused with LATE_RESULT and counted.
//  - A task whose attempt takes much longer than others of its stage may get a second one beside it (task_choice.h).
//    The first result that is taken settles it, and the other attempt is given up.
//  - No task is lost: while its job runs a task is pending, leased to a known worker, or settled.
//  - A task that was with `quarantine_after` workers when they were lost is quarantined, with their names.
//    Before its last chance it is given only to a worker that holds nothing, and alone, so that it takes no other task
//    down with it and no other task takes the blame.
//  - A task that a worker says cannot be done goes to another, if there is one. What that says settles it.
//    It gets it again only after `wait_for_another`.
//  - A task whose results were refused goes to another worker. It has failed when `max_refusals` workers gave a wrong
//    result, when two gave the same, or when nobody is left who might do better (task_choice.h): then the fault is not
//    theirs. If another does it well, the fault was theirs.
//  - When a worker is convicted, all its results in jobs that are not over are revoked.
//  - When an accepted result turns out to be wrong, its worker's results in that job are revoked.
//    The worker gets no task until the job ends. If the job ends well, the worker is convicted.
//    If this happens with `max_refusals` workers of one job, the fault is not theirs.
//  - A job takes at most one worker away from the others before that is known: the first whose result it refuses. When
//    it refuses those of a second, that speaks against the job, and both work on.
//  - Deterministic: the same events in the same order give the same state and the same choices.
//
//  - An attempt that failed by its machine is followed by another after a pause that doubles from time to time, and the
//    machine, if that happens to it again and again, gets nothing for such a pause.
//
// No I/O, no threads, no clock, no chance. Not thread-safe. An event costs O(log(tasks)), a lost worker O(held
// log(tasks)).
#ifndef TILEMEND_COORDINATOR_STATE_COORDINATOR_STATE_H_
#define TILEMEND_COORDINATOR_STATE_COORDINATOR_STATE_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/state/event.h"
#include "coordinator/state/job.h"

namespace tilemend {

struct StateOptions {
  int32_t quarantine_after = 3;  // >= 1, lost workers; or three times as many losses with fewer
  absl::Duration longest_attempt = absl::InfiniteDuration();  // then the lease ends, however often it is renewed
  int32_t max_refusals = 3;                                   // >= 1, workers whose results were refused
  // So long a task waits for a worker when all that there are failed with it, or their results were refused.
  absl::Duration wait_for_another = absl::Seconds(10);
  // >= 1, machine errors reported by living workers before one counts as the task's own, unless there is a worker left
  // that has not given it back; or three times as many.
  int32_t max_returns = 3;
  absl::Duration first_pause = absl::Milliseconds(250);  // after a machine error; doubles with each
  absl::Duration longest_pause = absl::Seconds(30);
  // A second attempt is worth it when the first takes this many times the mean of its job and stage, and this long.
  double straggler_factor = 3;
  absl::Duration least_straggling = absl::Seconds(1);
  // Versions of jobs start at epoch << 32. A coordinator that starts anew takes a larger epoch: its jobs are news to
  // whoever watched them before.
  uint32_t epoch = 0;
};

class CoordinatorState {
 public:
  explicit CoordinatorState(const StateOptions& options = {});

  // Changes the state by one event. An error changes nothing but the count of refused results:
  //   kNotFound (JOB_NOT_FOUND), kFailedPrecondition (JOB_OVER, LATE_RESULT), kAlreadyExists (a job of that name),
  //   kInvalidArgument (an event that does not fit: a lease of a task that is not pending, an unknown worker, ...).
  absl::StatusOr<Effects> Apply(const Event& event);

  // Null if there is none; a task that is settled is gone. Valid until the next Apply.
  const Job* FindJob(const std::string& job) const;
  const Job* FindRequest(const std::string& request_id) const;
  const Task* FindTask(const TaskKey& key) const;
  const WorkerRecord* FindWorker(const std::string& worker) const;

  const std::map<std::string, Job>& jobs() const { return jobs_; }
  const std::map<std::string, WorkerRecord>& workers() const { return workers_; }
  // By number: the oldest job first.
  const std::map<int64_t, std::string>& job_numbers() const { return job_numbers_; }
  // Those of the jobs that are not over.
  const std::map<int64_t, std::string>& running() const { return running_; }
  const StateOptions& options() const { return options_; }

 private:
  using Result = absl::StatusOr<Effects>;
  Result On(const JobCreated& event);
  Result On(const JobRestored& event);
  Result On(const TasksAdded& event);
  Result On(const WorkerSeen& event);
  Result On(const TaskLeased& event);
  Result On(const LeaseRenewed& event);
  Result On(const TaskCompleted& event);
  Result On(const TaskFailed& event);
  Result On(const TaskAbandoned& event);
  Result On(const LeaseExpired& event);
  Result On(const WorkerLost& event);
  Result On(const WorkerLeft& event);
  Result On(const JobProgressed& event);
  Result On(const JobWarned& event);
  Result On(const JobSteered& event);
  Result On(const JobCancelled& event);
  Result On(const WorkerDisproved& event);
  Result On(const JobRedone& event);
  Result On(const JobFinished& event);
  Result On(const JobForgotten& event);

  absl::StatusOr<Job*> RunningJob(const std::string& id);
  // The task of which that attempt is a lease; LATE_RESULT (not counted here) if it is none.
  absl::StatusOr<Task*> LeasedTask(const TaskKey& key, const std::string& worker, uint64_t token);
  // For results: as LeasedTask, but null for a repeated report of the attempt that settled the task, and counting.
  absl::StatusOr<Task*> TaskForResult(const TaskKey& key, const std::string& worker, uint64_t token);
  void EndLease(Job& job, Task& task, const std::string& worker);
  void EndLeases(Job& job, Task& task);
  // Of an attempt of `worker`, which gave no result. The task is pending again unless there is another attempt.
  void GiveUp(Job& job, Task& task, const std::string& worker, Effects& effects);
  // Of a leased task; `result` says how, `worker` whose attempt it was.
  void Settle(Job& job, Task& task, const std::string& worker, KnownResult result, Effects& effects);
  // Of one that is pending or leased no more. Forgets the task.
  void EnterResult(Job& job, Task& task, SettledTask settled, Effects& effects);
  // Ends all leases and forgets all tasks and results of the job.
  void DropTasks(Job& job, Effects& effects);
  void Insert(Job job);
  void LoseLease(Job& job, Task& task, const std::string& worker, Effects& effects);
  using TaskLoss = void (CoordinatorState::*)(Job& job, Task& task, const std::string& worker, Effects& effects);
  // Ends the worker, and each of its attempts with `lose`.
  absl::StatusOr<Effects> TakeTasksFrom(const std::string& name, TaskLoss lose, Effects effects = {});
  // Whether the worker told that it is at others of the tasks that it holds, and not at this one.
  bool HasBegunOthers(const Task& task, const std::string& worker) const;
  // Whether the task has failed by an error of its own: one worker's word is not enough where there is another.
  bool Fail(Task& task, const TaskFailed& event) const;
  // What a machine error means for the task and the worker; whether the task has failed by it.
  bool Return(Task& task, const TaskFailed& event);
  absl::Duration PauseAfter(int32_t failures) const;
  void EndJob(Job& job, JobState state, absl::Time time, Effects& effects);
  // Of a job when it gets known here: above all that an earlier epoch can have reached.
  uint64_t FirstVersion() const { return (static_cast<uint64_t>(options_.epoch) << 32) + 1; }

  StateOptions options_;
  std::map<std::string, Job> jobs_;
  std::map<int64_t, std::string> job_numbers_;
  std::map<int64_t, std::string> running_;
  int64_t last_number_ = 0;  // of a job
  std::map<std::string, std::string> requests_;
  std::map<std::string, WorkerRecord> workers_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_COORDINATOR_STATE_H_
