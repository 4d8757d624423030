// What the coordinator counts.
#ifndef TILEMEND_COORDINATOR_JOBS_COORDINATOR_METRICS_H_
#define TILEMEND_COORDINATOR_JOBS_COORDINATOR_METRICS_H_

#include <array>

#include "absl/time/time.h"
#include "common/metrics/metrics.h"
#include "common/util/stage.h"
#include "coordinator/jobs/worker_trust.h"
#include "coordinator/state/coordinator_state.h"

namespace tilemend {

// Thread-safe: handles of a registry, kept.
class CoordinatorMetrics {
 public:
  explicit CoordinatorMetrics(MetricsRegistry& registry);

  void Started(Stage stage) { Of(stage).started->Increment(); }
  void Retried(Stage stage) { Of(stage).retried->Increment(); }
  // A result: late if its attempt had been given up, else wrong.
  void Refused(Stage stage, bool is_late) { (is_late ? Of(stage).refused_late : Of(stage).refused)->Increment(); }
  void Settled(const SettledTask& task, absl::Time now);
  void BlobSent(int64_t bytes) { blob_bytes_sent_->Increment(static_cast<double>(bytes)); }
  void BlobReceived(int64_t bytes) { blob_bytes_received_->Increment(static_cast<double>(bytes)); }
  // Sets the gauges: O(jobs).
  void Show(const CoordinatorState& state);
  void ShowTrust(const WorkerTrust::Counts& counts);

 private:
  struct PerStage {
    Counter* started;
    Counter* finished;
    Counter* failed;
    Counter* quarantined;
    Counter* retried;
    Counter* refused_late;
    Counter* refused;
    Histogram* seconds;
  };
  // The last one takes what a worker calls by no known stage.
  PerStage& Of(Stage stage);

  std::array<PerStage, kAllStages.size() + 1> stages_;
  std::array<Gauge*, 5> jobs_;
  Gauge* workers_;
  Gauge* workers_set_aside_;
  Gauge* workers_blind_;
  Gauge* task_slots_;
  Gauge* tasks_pending_;
  Gauge* tasks_running_;
  Counter* blob_bytes_sent_;
  Counter* blob_bytes_received_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_COORDINATOR_METRICS_H_
