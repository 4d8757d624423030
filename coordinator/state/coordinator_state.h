// The coordinator's state: jobs, their tasks and the workers that hold them, changed by events alone.
//
// Guarantees
//  - Execution at least once, commit exactly once: a result counts only if it carries the token of the task's present
//    lease. A second report of the attempt that settled a task is accepted and changes nothing (its answer was lost);
//    any other late result is refused with LATE_RESULT and counted.
//  - No task is lost: while its job runs a task is pending, leased to a known worker, or settled.
//  - A task that was with `quarantine_after` workers when they were lost is quarantined, with their names.
//    Before its last chance it is given only to a worker that holds nothing, and alone, so that it takes no other task
//    down with it and no other task takes the blame.
//  - A task whose results were refused goes to another worker. It has failed when `max_refusals` workers gave a wrong
//    result, or two gave the same: then the fault is not theirs.
//  - Deterministic: the same events in the same order give the same state and the same choices.
//
// No I/O, no threads, no clock. Not thread-safe. An event costs O(log(tasks)), a lost worker O(held log(tasks)).
#ifndef TILEMEND_COORDINATOR_STATE_COORDINATOR_STATE_H_
#define TILEMEND_COORDINATOR_STATE_COORDINATOR_STATE_H_

#include <cstdint>
#include <functional>
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
  int32_t max_returns = 3;  // >= 1, machine errors reported by living workers before one counts as the task's own
  // Tokens of attempts and versions of jobs start at epoch << 32. A coordinator that starts anew takes a larger epoch:
  // it refuses what an earlier one gave out, and its jobs are news to whoever watched them before.
  uint32_t epoch = 0;
};

class CoordinatorState {
 public:
  explicit CoordinatorState(const StateOptions& options = {});

  // Changes the state by one event. An error changes nothing but the count of refused results:
  //   kNotFound (JOB_NOT_FOUND), kFailedPrecondition (JOB_OVER, LATE_RESULT), kAlreadyExists (a job of that name),
  //   kInvalidArgument (an event that does not fit: a lease of a task that is not pending, an unknown worker, ...).
  absl::StatusOr<Effects> Apply(const Event& event);

  // The tasks to lease to `worker` now, at most as many as it has free threads: oldest job first, then in the order in
  // which the pipeline added them. Empty for an unknown or draining worker. Only of jobs that it `may` work on, and no
  // task of which its result was refused, or which it gave back while another worker may have it that did not.
  using MayWork = std::function<bool(const std::string& worker, const std::string& job)>;
  std::vector<TaskKey> ChooseTasks(
      const std::string& worker, const MayWork& may = [](const auto&, const auto&) { return true; }) const;
  // Whether a worker other than `worker` may have a task of the job and has not given this one back.
  bool HasAnother(const std::string& worker, const Job& job, const Task& task, const MayWork& may) const;

  // A token for the next TaskLeased: larger than all that were applied.
  uint64_t NextToken() const { return last_token_ + 1; }

  // Events for what is overdue at `now`: workers not seen for `silence`, then leases beyond their deadline.
  std::vector<Event> Overdue(absl::Time now, absl::Duration silence) const;

  // Null if there is none. Valid until the next Apply.
  const Job* FindJob(const std::string& job) const;
  const Job* FindRequest(const std::string& request_id) const;
  const Task* FindTask(const TaskKey& key) const;
  const WorkerRecord* FindWorker(const std::string& worker) const;

  const std::map<std::string, Job>& jobs() const { return jobs_; }
  const std::map<std::string, WorkerRecord>& workers() const { return workers_; }
  // By number: the oldest job first.
  const std::map<int64_t, std::string>& job_numbers() const { return job_numbers_; }

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
  Result On(const LeaseExpired& event);
  Result On(const WorkerLost& event);
  Result On(const WorkerLeft& event);
  Result On(const JobProgressed& event);
  Result On(const JobWarned& event);
  Result On(const JobCancelled& event);
  Result On(const JobFinished& event);

  absl::StatusOr<Job*> RunningJob(const std::string& id);
  // The task whose present lease is `token`; LATE_RESULT (not counted here) if the lease is another or none.
  absl::StatusOr<Task*> LeasedTask(const TaskKey& key, uint64_t token);
  // For results: as LeasedTask, but null for a repeated report of the attempt that settled the task, and counting.
  absl::StatusOr<Task*> TaskForResult(const TaskKey& key, uint64_t token);
  void EndLease(Job& job, Task& task);
  void BackToPending(Job& job, Task& task, Effects& effects);
  // Of a leased task; `result` says how.
  void Settle(Job& job, Task& task, KnownResult result, Effects& effects);
  // Of one that is pending or leased no more.
  void EnterResult(Job& job, Task& task, KnownResult result, bool known, Effects& effects);
  void Insert(Job job);
  void LoseLease(Job& job, Task& task, Effects& effects);
  // Puts a refusal down; whether the task has failed by it.
  bool Refuse(Task& task, const std::string& digest) const;
  void EndJob(Job& job, JobState state, absl::Time time);
  // Of a job when it gets known here: above all that an earlier epoch can have reached.
  uint64_t FirstVersion() const { return (static_cast<uint64_t>(options_.epoch) << 32) + 1; }
  bool IsLastChance(const Task& task) const;

  StateOptions options_;
  uint64_t last_token_ = 0;
  std::map<std::string, Job> jobs_;
  std::map<int64_t, std::string> job_numbers_;
  std::map<int64_t, std::string> running_;  // job_numbers_ of the jobs that are not over
  std::map<std::string, std::string> requests_;
  std::map<std::string, WorkerRecord> workers_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_COORDINATOR_STATE_H_
