// The calls of a worker to its coordinator, one after the other until the worker ends.
#ifndef TILEMEND_WORKER_SERVICE_SYNC_LOOP_H_
#define TILEMEND_WORKER_SERVICE_SYNC_LOOP_H_

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "worker/service/coordinator_contact.h"
#include "worker/service/work_link.h"
#include "worker/service/worker_options.h"
#include "worker/service/worker_state.h"

namespace tilemend {

// Of one thread.
class SyncLoop {
 public:
  // All must outlive this.
  SyncLoop(const WorkerOptions& options, WorkLink& link, WorkerState& state, CoordinatorContact& contact);

  // An error if the coordinator refuses to work with this worker, or was out of reach for too long.
  absl::Status Run();

 private:
  bool CallOnce();  // false: the end
  bool AfterFailure(const absl::Status& status);
  v1::SyncRequest NewRequest();

  const WorkerOptions& options_;
  WorkLink& link_;
  WorkerState& state_;
  CoordinatorContact& contact_;
  const std::string secret_;
  absl::Duration backoff_;
  absl::Duration in_vain_;  // since the last call that was answered
  uint64_t sequence_ = 0;
  absl::Status end_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_SYNC_LOOP_H_
