// What a worker counts.
#ifndef TILEMEND_WORKER_SERVICE_WORKER_METRICS_H_
#define TILEMEND_WORKER_SERVICE_WORKER_METRICS_H_

#include <array>

#include "common/metrics/metrics.h"
#include "common/util/stage.h"

namespace tilemend {

// Thread-safe: handles of a registry, kept.
class WorkerMetrics {
 public:
  struct PerStage {
    Counter* started;
    Counter* finished;
    Counter* failed;
    Counter* cancelled;
    Counter* bytes_in;
    Counter* bytes_out;
    Histogram* seconds;
  };

  explicit WorkerMetrics(MetricsRegistry& registry);

  PerStage& Of(Stage stage);
  void SetConnected(bool connected) { connected_->Set(connected ? 1 : 0); }

 private:
  std::array<PerStage, kAllStages.size() + 1> stages_;  // the last one is for stages of another release
  Gauge* connected_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_WORKER_METRICS_H_
