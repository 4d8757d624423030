// What a worker is told: the tasks that it keeps and begins, and the folders to look at.
#ifndef TILEMEND_COORDINATOR_API_WORKER_NEWS_H_
#define TILEMEND_COORDINATOR_API_WORKER_NEWS_H_

#include <optional>
#include <string>

#include "absl/status/status.h"
#include "coordinator/api/waiting_syncs.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/jobs/state_updates.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

// All methods need the lock.
class WorkerNews {
 public:
  // All must outlive this.
  WorkerNews(Cluster& cluster, StateUpdates& updates, const JobJournal& journal)
      : cluster_(cluster), updates_(updates), journal_(journal) {}

  // The end of the call, if it has come to it: with news for the worker, or kAborted if a newer call took over. Leases
  // the tasks that the worker is told to begin.
  std::optional<absl::Status> EndOf(WorkerSync& sync);

 private:
  void TellState(const v1::SyncRequest& request, v1::SyncResponse& response);
  void TellToLook(const v1::SyncRequest& request, v1::SyncResponse& response) const;
  void LeaseTasks(const std::string& worker);

  Cluster& cluster_;
  StateUpdates& updates_;
  const JobJournal& journal_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_WORKER_NEWS_H_
