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
//  - When a worker is set aside, all its results in jobs that are not over are revoked.
//  - When an accepted result turns out to be wrong, its worker's results in that job are revoked.
//    The worker gets no task until the job ends. If the job ends well, the worker is set aside.
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

#include "absl/status/statusor.h"
#include "coordinator/state/event.h"
#include "coordinator/state/job.h"
#include "coordinator/state/state_tables.h"

namespace tilemend {

class CoordinatorState {
 public:
  explicit CoordinatorState(const StateOptions& options = {}) : tables_{options, {}, {}} {}

  // Changes the state by one event. An error changes nothing but the count of refused results:
  //   kNotFound (JOB_NOT_FOUND), kFailedPrecondition (JOB_OVER, LATE_RESULT), kAlreadyExists (a job of that name),
  //   kInvalidArgument (an event that does not fit: a lease of a task that is not pending, an unknown worker, ...).
  absl::StatusOr<Effects> Apply(const Event& event);

  // Null if there is none; a task that is settled is gone. Valid until the next Apply.
  const Job* FindJob(const std::string& job) const { return tables_.jobs.Find(job); }
  const Job* FindRequest(const std::string& request_id) const { return tables_.jobs.FindRequest(request_id); }
  const Task* FindTask(const TaskKey& key) const { return tables_.jobs.FindTask(key); }
  const WorkerRecord* FindWorker(const std::string& worker) const;

  const std::map<std::string, Job>& jobs() const { return tables_.jobs.all(); }
  const std::map<std::string, WorkerRecord>& workers() const { return tables_.workers; }
  // By number: the oldest job first.
  const std::map<int64_t, std::string>& job_numbers() const { return tables_.jobs.numbers(); }
  // Those of the jobs that are not over.
  const std::map<int64_t, std::string>& running() const { return tables_.jobs.running(); }
  const StateOptions& options() const { return tables_.options; }

 private:
  StateTables tables_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_COORDINATOR_STATE_H_
