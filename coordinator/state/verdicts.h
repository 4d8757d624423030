// Which worker is at fault when results are wrong (guarantees: coordinator_state.h).
#ifndef TILEMEND_COORDINATOR_STATE_VERDICTS_H_
#define TILEMEND_COORDINATOR_STATE_VERDICTS_H_

#include <cstdint>

#include "absl/status/statusor.h"
#include "coordinator/state/event.h"
#include "coordinator/state/job.h"
#include "coordinator/state/job_table.h"

namespace tilemend {

// Enters the refusal of a result. Whether the task has failed by it.
bool AddRefusal(int32_t max_refusals, const TaskFailed& event, Job& job, Task& task);
// Whom the refusal of one of the worker's results speaks against.
void SuspectRefused(const Job& job, const TaskFailed& event, Effects& effects);
// Who gave the refused results of a task that is settled.
void JudgeRefusals(Job& job, Task& task, Effects& effects);
// The job's tasks are dropped.
void ForgetRefusals(Job& job, Effects& effects);

// An accepted result is wrong. kFailedPrecondition if that is not the worker's fault, or no other can do it.
absl::StatusOr<Effects> Disprove(int32_t max_refusals, const WorkerDisproved& event, Job& job);
// The job ended in `state`.
void JudgeDisproved(Job& job, JobState state, Effects& effects);

// Revokes all results of the workers that are set aside in jobs that run.
void RevokeOfSetAside(JobTable& jobs, Effects& effects);
// Clears nobody whom a job that runs has disproved: its tasks are for others.
void KeepDisprovedSuspected(const JobTable& jobs, Effects& effects);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_VERDICTS_H_
