// The call by which workers get tasks and report results.
#ifndef TILEMEND_COORDINATOR_API_WORK_HANDLER_H_
#define TILEMEND_COORDINATOR_API_WORK_HANDLER_H_

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/api/crew.h"
#include "coordinator/api/long_calls.h"
#include "coordinator/api/result_intake.h"
#include "coordinator/api/waiting_syncs.h"
#include "coordinator/api/worker_news.h"
#include "coordinator/api/worker_reports.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/jobs/state_updates.h"
#include "coordinator/store/blob_folder.h"
#include "tilemend/v1/work.pb.h"

namespace tilemend {

// Thread-safe. A call that waits holds no thread. Results are checked by a few threads, and answers given by others.
class WorkHandler {
 public:
  // All must outlive this.
  WorkHandler(Cluster& cluster, StateUpdates& updates, const JobJournal& journal);
  // Every call has ended: the coordinator waits no more, and no other call comes.
  ~WorkHandler();

  // Waits for news as the call's message says, then answers, on any thread. Does not wait itself.
  void Sync(std::shared_ptr<WorkerSync> sync);
  // `alive` says so no more. Nothing is leased to a worker that does not wait for its answer.
  void Gone(const std::string& worker);

 private:
  // An answer that waits until it is durable.
  struct Answer {
    std::shared_ptr<WorkerSync> sync;
    absl::Status status;
    std::map<std::string, std::shared_ptr<BlobFolder>> blobs = {};  // of the tasks in it, by job
  };

  absl::Status Refusal(const v1::SyncRequest& request);
  // Whether the call may wait until what it reports is checked. If so it counts until then.
  bool HasRoomFor(const WorkerSync& sync);
  void Check(const std::shared_ptr<WorkerSync>& sync);
  // What the call says takes effect; then it waits.
  void Enter(const std::shared_ptr<WorkerSync>& sync, std::vector<ResultIntake::Report> reports);
  // With the lock held.
  bool TryToAnswer(const std::shared_ptr<WorkerSync>& sync);
  void Give(std::vector<Answer> answers);

  Cluster& cluster_;
  WorkerReports reports_;
  WorkerNews news_;
  LongCalls calls_;
  Crew<Answer> answers_;
  WaitingSyncs waiting_;
  int64_t unchecked_bytes_ = 0;  // of calls in checks_. Guarded by the lock.
  Crew<std::shared_ptr<WorkerSync>> checks_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_WORK_HANDLER_H_
