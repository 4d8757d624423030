// Runs the tasks of a worker.
#ifndef TILEMEND_WORKER_SERVICE_TASK_RUNNER_H_
#define TILEMEND_WORKER_SERVICE_TASK_RUNNER_H_

#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "common/util/cores.h"
#include "tilemend/v1/work.pb.h"
#include "worker/service/held_tasks.h"
#include "worker/service/stage_runner.h"
#include "worker/service/task_blobs.h"
#include "worker/service/worker_metrics.h"
#include "worker/service/worker_options.h"
#include "worker/service/worker_state.h"

namespace tilemend {

// Thread-safe: as many tasks compute at a time as the worker has threads, the others fetch inputs and send outputs.
class TaskRunner {
 public:
  // All must outlive this.
  TaskRunner(const WorkerOptions& options, StageRunner runner, TaskBlobs& blobs, WorkerState& state,
             WorkerMetrics& metrics);

  // Runs the next tasks and looks at folders, until the worker has ended.
  void RunAll();

 private:
  void Run(HeldTask& held);
  // None: it was dropped before there was a core for it.
  std::optional<absl::StatusOr<std::string>> Compute(HeldTask& held, const std::string& input);
  v1::FinishedTask Report(const HeldTask& held, absl::StatusOr<std::string> output);

  const WorkerOptions& options_;
  const StageRunner runner_;
  TaskBlobs& blobs_;
  WorkerState& state_;
  WorkerMetrics& metrics_;
  Cores cores_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_TASK_RUNNER_H_
