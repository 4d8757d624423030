// Whether a worker gets tasks from its coordinator, and why it does not.
#ifndef TILEMEND_WORKER_SERVICE_COORDINATOR_CONTACT_H_
#define TILEMEND_WORKER_SERVICE_COORDINATOR_CONTACT_H_

#include <mutex>
#include <string>

#include "absl/status/status.h"
#include "common/util/log.h"
#include "worker/service/worker_metrics.h"

namespace tilemend {

// Thread-safe. Changes are logged.
class CoordinatorContact {
 public:
  // Both must outlive this.
  CoordinatorContact(Log& log, WorkerMetrics& metrics);

  // How a call ended: answered, or why not.
  void SetConnected(const absl::Status& status);
  // Why the coordinator gives this worker no tasks; "" if it does.
  void SetAside(const std::string& reason);

  bool is_connected() const;
  // For people; "" if the worker can get tasks.
  std::string WhyNotReady() const;

 private:
  Log& log_;
  WorkerMetrics& metrics_;
  mutable std::mutex mutex_;
  std::string unconnected_;  // why; "" while it is connected
  std::string set_aside_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_COORDINATOR_CONTACT_H_
