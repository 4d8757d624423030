// A worker: asks the coordinator for tasks, runs them on its threads and reports what came out.
//
// One thread makes Sync calls; of others at most `threads` compute at a time, beside those that read and write
// (common/util/cores.h). A call waits in the coordinator while there is room for tasks here. When a task ends it is
// interrupted and a new one reports at once. While more tasks wait than half of `prefetch`, no call is made for up to
// 100 ms. Results are kept and reported again until the coordinator acknowledges them, through any loss of connection.
#ifndef TILEMEND_WORKER_SERVICE_WORKER_H_
#define TILEMEND_WORKER_SERVICE_WORKER_H_

#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "common/metrics/metrics.h"
#include "worker/service/coordinator_contact.h"
#include "worker/service/stage_runner.h"
#include "worker/service/sync_loop.h"
#include "worker/service/task_blobs.h"
#include "worker/service/task_runner.h"
#include "worker/service/work_link.h"
#include "worker/service/worker_metrics.h"
#include "worker/service/worker_options.h"
#include "worker/service/worker_state.h"

namespace tilemend {

// Thread-safe.
class Worker {
 public:
  // Starts at once.
  Worker(const WorkerOptions& options, std::unique_ptr<WorkLink> link, StageRunner runner, MetricsRegistry& metrics);
  // Stops and waits.
  ~Worker();

  // Takes no more tasks, finishes and reports those it has, then ends.
  void Drain();
  // Drops what runs, tells the coordinator (once) so that it gives the tasks to others without delay, then ends.
  void Stop();
  // Drops what runs and tells nobody, as if the machine had died.
  void Abandon();

  // Why it cannot get tasks now, for people; "" if it can.
  std::string WhyNotReady();

  // Waits for the end. An error if the coordinator refuses to work with this worker, or was out of reach for too long.
  absl::Status Join();

 private:
  void CallUntilTheEnd();

  const WorkerOptions options_;
  const std::unique_ptr<WorkLink> link_;
  WorkerMetrics metrics_;
  CoordinatorContact contact_;
  WorkerState state_;
  SyncLoop loop_;
  TaskBlobs blobs_;
  TaskRunner runner_;
  absl::Status end_;  // of the loop's thread until it is joined
  std::mutex join_mutex_;
  std::vector<std::thread> threads_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_WORKER_H_
