// What happens to tasks while workers have them.
#ifndef TILEMEND_COORDINATOR_STATE_LEASE_EVENTS_H_
#define TILEMEND_COORDINATOR_STATE_LEASE_EVENTS_H_

#include "absl/status/statusor.h"
#include "coordinator/state/event.h"
#include "coordinator/state/state_tables.h"

namespace tilemend {

// Guarantees and errors: coordinator_state.h.
absl::StatusOr<Effects> On(const TaskLeased& event, StateTables& state);
absl::StatusOr<Effects> On(const LeaseRenewed& event, StateTables& state);
absl::StatusOr<Effects> On(const TaskCompleted& event, StateTables& state);
absl::StatusOr<Effects> On(const TaskFailed& event, StateTables& state);
absl::StatusOr<Effects> On(const TaskAbandoned& event, StateTables& state);
absl::StatusOr<Effects> On(const LeaseExpired& event, StateTables& state);
absl::StatusOr<Effects> On(const WorkerLost& event, StateTables& state);
absl::StatusOr<Effects> On(const WorkerLeft& event, StateTables& state);

// Enters how a task that is pending or leased no more was settled, and forgets the task.
void EnterResult(Job& job, Task& task, SettledTask settled, Effects& effects);
// Ends all leases and forgets all tasks and results of the job.
void DropTasks(Job& job, StateTables& state, Effects& effects);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_LEASE_EVENTS_H_
