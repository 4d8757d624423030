// Which tasks a worker is to get, and which leases are overdue: decisions on a CoordinatorState that change nothing.
#ifndef TILEMEND_COORDINATOR_STATE_TASK_CHOICE_H_
#define TILEMEND_COORDINATOR_STATE_TASK_CHOICE_H_

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "absl/time/time.h"
#include "coordinator/state/coordinator_state.h"

namespace tilemend {

using MayWork = std::function<bool(const std::string& worker, const std::string& job)>;
bool MayAlways(const std::string& worker, const std::string& job);

// The tasks to lease to `worker` now, at most as many as it has free threads, and of those that it would prefetch as
// long as more wait than all other workers together can hold. The next task is of the
// job with the highest priority; of those with the same, which share alike, of the one that has the fewest leases, the
// older one if two have as many; within a job it is the first that the pipeline added, background tasks after all
// others. None of a paused job. Empty for an unknown, draining or resting worker. Only of jobs that it `may` work on,
// and no task of which its result was refused, that is to wait, or that it gave back while another worker may have it
// that did not. If there is none: second attempts at tasks that take long, the oldest of each job first. Deterministic.
// Cost: O(jobs + pending tasks that the worker may not have).
std::vector<TaskKey> ChooseTasks(const CoordinatorState& state, const std::string& worker, absl::Time now,
                                 const MayWork& may = MayAlways);

// Whether a worker other than `worker` may have a task of the job, has not given this one back, and gave no result of
// it that was refused.
bool HasAnother(const CoordinatorState& state, const std::string& worker, const Job& job, const Task& task,
                const MayWork& may);

// Whether a worker other than `worker` may have tasks of the job.
bool HasOtherWorker(const CoordinatorState& state, const std::string& worker, const std::string& job,
                    const MayWork& may);

// Events for what is overdue at `now`: workers not seen for `silence`, then leases beyond their deadline. Leaves out
// the workers in `heard`: they wait for an answer of the coordinator.
std::vector<Event> Overdue(const CoordinatorState& state, absl::Time now, absl::Duration silence,
                           const std::set<std::string>& heard = {});

// Events for tasks of which results were refused, the last one `wait_for_another` ago, and that no worker may have.
std::vector<Event> Abandoned(const CoordinatorState& state, absl::Time now, const MayWork& may);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_TASK_CHOICE_H_
