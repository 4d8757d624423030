// What a worker says of itself, of its tasks and of folders, and how that takes effect.
#ifndef TILEMEND_COORDINATOR_API_WORKER_REPORTS_H_
#define TILEMEND_COORDINATOR_API_WORKER_REPORTS_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/api/result_intake.h"
#include "coordinator/api/waiting_syncs.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/state_updates.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

// All public methods but Check need the lock.
class WorkerReports {
 public:
  // Both must outlive this.
  WorkerReports(Cluster& cluster, StateUpdates& updates)
      : cluster_(cluster), updates_(updates), results_(cluster, updates) {}

  // The worker, which was just heard, has so many more calls whose reports are checked; until those are none, it does
  // not count as silent.
  void CountChecks(const WorkerSync& sync, int change);
  // Whether results can be what was asked for. Their content goes from the call into the reports. Without the lock;
  // reads files and computes.
  std::vector<ResultIntake::Report> Check(v1::SyncRequest& request);
  // The call is the newest of its worker from now on. kPermissionDenied if another process has called itself so.
  absl::Status TakeOver(const v1::SyncRequest& request, const std::string& identity);
  // What the call says takes effect. Gives the lock up in between, to delete and to look at files.
  absl::Status Take(WorkerSync& sync, std::vector<ResultIntake::Report> reports, ClusterLock& lock);

 private:
  void TakeResults(const v1::SyncRequest& request, std::vector<ResultIntake::Report> reports, ClusterLock& lock,
                   v1::SyncResponse& response);
  // Gives the jobs whose folders the worker does not see.
  std::vector<std::string> TakeSeen(const v1::SyncRequest& request);
  void FailJobsThatAreGone(const std::vector<std::string>& jobs);  // without the lock
  void RenewHeld(const v1::SyncRequest& request);

  Cluster& cluster_;
  StateUpdates& updates_;
  ResultIntake results_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_WORKER_REPORTS_H_
