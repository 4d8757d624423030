// The call by which workers get tasks and report results.
#ifndef TILEMEND_COORDINATOR_API_WORK_HANDLER_H_
#define TILEMEND_COORDINATOR_API_WORK_HANDLER_H_

#include <functional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/api/result_intake.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/jobs/state_updates.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

// Thread-safe.
class WorkHandler {
 public:
  // All must outlive this.
  WorkHandler(Cluster& cluster, StateUpdates& updates, const JobJournal& journal)
      : cluster_(cluster), updates_(updates), journal_(journal), results_(cluster, updates) {}

  // Waits for news as its message says. `alive` tells whether the worker still waits for the answer: nothing is leased
  // to one that does not.
  absl::StatusOr<v1::SyncResponse> Sync(const v1::SyncRequest& request, const std::function<bool()>& alive,
                                        const std::string& identity = "");

 private:
  // All but the first and FailJobsThatAreGone with the lock held.
  // However long it takes, the worker does not count as silent meanwhile.
  std::vector<ResultIntake::Report> LookAtResults(const v1::SyncRequest& request, const std::string& identity);
  // Enters them in the state. Gives the lock up while it deletes files of results that are not accepted.
  void TakeResults(const v1::SyncRequest& request, std::vector<ResultIntake::Report> reports, ClusterLock& lock,
                   v1::SyncResponse& response);
  // Whether another process has called itself so.
  absl::Status CheckSecret(const v1::SyncRequest& request, const std::string& identity);
  // Gives the jobs whose folders the worker does not see.
  std::vector<std::string> TakeSeen(const v1::SyncRequest& request);
  void FailJobsThatAreGone(const std::vector<std::string>& jobs);
  void RenewHeld(const v1::SyncRequest& request);
  // Waits until there is news for the worker and writes it down; kAborted if a newer call took over.
  absl::Status AwaitNews(const v1::SyncRequest& request, const std::function<bool()>& alive, ClusterLock& lock,
                         v1::SyncResponse& response);
  void TellState(const v1::SyncRequest& request, v1::SyncResponse& response);
  void TellToLook(const v1::SyncRequest& request, v1::SyncResponse& response) const;
  void LeaseTasks(const std::string& worker);

  Cluster& cluster_;
  StateUpdates& updates_;
  const JobJournal& journal_;
  ResultIntake results_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_WORK_HANDLER_H_
