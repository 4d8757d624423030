// The inputs of a worker's tasks, fetched from the coordinator, and their outputs, sent to it.
#ifndef TILEMEND_WORKER_SERVICE_TASK_BLOBS_H_
#define TILEMEND_WORKER_SERVICE_TASK_BLOBS_H_

#include <memory>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/util/recently_used.h"
#include "tilemend/v1/work.pb.h"
#include "worker/service/coordinator_contact.h"
#include "worker/service/held_tasks.h"
#include "worker/service/work_link.h"
#include "worker/service/worker_options.h"
#include "worker/service/worker_state.h"

namespace tilemend {

// Thread-safe. What fails for want of a connection is tried again: for 2.6 seconds while the worker is connected, else
// until the task's result is of no use.
class TaskBlobs {
 public:
  // All must outlive this.
  TaskBlobs(const WorkerOptions& options, WorkLink& link, WorkerState& state, const CoordinatorContact& contact);

  // With its parts.
  absl::StatusOr<std::string> Input(const HeldTask& held);
  // A blob of the coordinator, unless the bytes are so few that they are told with the result.
  absl::StatusOr<v1::BlobRef> Store(const HeldTask& held, std::string output);

 private:
  absl::StatusOr<std::shared_ptr<const std::string>> Part(const HeldTask& held, const std::string& digest);
  absl::StatusOr<std::string> Fetch(const HeldTask& held, const std::string& digest);
  // Whether a call for the task that failed so is worth another try; waits before that.
  bool MayTryAgain(const HeldTask& held, const absl::Status& status, int tried);

  const WorkerOptions& options_;
  WorkLink& link_;
  WorkerState& state_;
  const CoordinatorContact& contact_;
  RecentlyUsed<std::string, std::string> parts_;  // of inputs, by digest
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_TASK_BLOBS_H_
