// How a coordinator goes on with the jobs that its journal has.
#ifndef TILEMEND_COORDINATOR_JOBS_RESTORE_JOBS_H_
#define TILEMEND_COORDINATOR_JOBS_RESTORE_JOBS_H_

#include <atomic>
#include <cstdint>
#include <thread>

#include "absl/status/status.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/jobs/job_runs.h"
#include "coordinator/jobs/state_updates.h"
#include "coordinator/journal/journal.h"

namespace tilemend {

class JobRestorer {
 public:
  // All must outlive this.
  JobRestorer(Cluster& cluster, StateUpdates& updates, const JobJournal& journal, JobRuns& runs)
      : cluster_(cluster), updates_(updates), journal_(journal), runs_(runs) {}
  ~JobRestorer() { StopSweeping(); }

  // Puts the jobs of the journal into the cluster, starts those that are not over, and removes the folders that no job
  // needs. Call it once, before anything else. A job whose record is damaged fails alone. kPermissionDenied if an old
  // folder cannot be removed.
  absl::Status Restore();
  // Ends the removal of old folders early, and waits for its thread.
  void StopSweeping();

 private:
  absl::Status RestoreJob(JobRecord record);
  absl::Status RestoreAsFailed(int64_t number, const absl::Status& why);
  absl::Status SweepFolders();

  Cluster& cluster_;
  StateUpdates& updates_;
  const JobJournal& journal_;
  JobRuns& runs_;
  std::atomic<bool> leaving_{false};  // the coordinator ends
  std::thread sweeper_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_RESTORE_JOBS_H_
