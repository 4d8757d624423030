// Jobs that are paused, resumed, preferred or cancelled.
#ifndef TILEMEND_COORDINATOR_JOBS_STEER_JOB_H_
#define TILEMEND_COORDINATOR_JOBS_STEER_JOB_H_

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/jobs/state_updates.h"
#include "coordinator/state/event.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// kInvalidArgument (INVALID_PRIORITY) unless it is from -100 to 100.
absl::Status CheckPriority(int32_t priority);

// All methods need the lock; `name` is jobs/ID. Errors of Cluster::JobNamed, kFailedPrecondition (JOB_OVER).
class JobSteering {
 public:
  // All must outlive this.
  JobSteering(Cluster& cluster, StateUpdates& updates, const JobJournal& journal)
      : cluster_(cluster), updates_(updates), journal_(journal) {}

  // Pauses the job, resumes it, or changes its priority, as `change` says.
  absl::StatusOr<v1::Job> Steer(const std::string& name, JobSteered change);
  // Cancels the job. A job that is cancelled already stays as it is.
  absl::StatusOr<v1::Job> Cancel(const std::string& name);

 private:
  Cluster& cluster_;
  StateUpdates& updates_;
  const JobJournal& journal_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_STEER_JOB_H_
