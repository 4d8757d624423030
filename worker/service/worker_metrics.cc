#include "worker/service/worker_metrics.h"

#include <string>

namespace tilemend {

WorkerMetrics::WorkerMetrics(MetricsRegistry& registry) {
  const std::string prefix = "tilemend_worker_";
  for (size_t i = 0; i < stages_.size(); ++i) {
    const std::string_view name = i < kAllStages.size() ? StageName(kAllStages[i]) : "unknown";
    const MetricsRegistry::Labels labels = {{"stage", std::string(name)}};
    PerStage& stage = stages_[i];
    stage.started = registry.AddCounter(prefix + "tasks_started_total", "Tasks begun.", labels);
    stage.finished = registry.AddCounter(prefix + "tasks_finished_total", "Tasks that gave an output.", labels);
    stage.failed = registry.AddCounter(prefix + "tasks_failed_total", "Tasks that gave an error.", labels);
    stage.cancelled = registry.AddCounter(prefix + "tasks_cancelled_total", "Tasks dropped on request.", labels);
    stage.bytes_in = registry.AddCounter(prefix + "input_bytes_total", "Bytes of inputs.", labels);
    stage.bytes_out = registry.AddCounter(prefix + "output_bytes_total", "Bytes of outputs.", labels);
    stage.seconds = registry.AddHistogram(prefix + "task_seconds", "Time of a task, with its input and output.", labels,
                                          Histogram::ScaledBounds(0.001, 2, 20));
  }
  connected_ = registry.AddGauge(prefix + "connected", "1 while the coordinator answers.", {});
}

WorkerMetrics::PerStage& WorkerMetrics::Of(Stage stage) { return stages_[StageIndex(stage)]; }

}  // namespace tilemend
