// Figures on jobs: how they ended, how long they took, what was filled, and how far those are that run.
#ifndef TILEMEND_COORDINATOR_JOBS_JOB_METRICS_H_
#define TILEMEND_COORDINATOR_JOBS_JOB_METRICS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "common/metrics/metrics.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/state/coordinator_state.h"

namespace tilemend {

// The share of a job that is done, 0 to 1. While not all of its tasks are known, a guess that may fall.
double ShareDone(const Job& job);
// Of a job that runs, by its phase (wave_order.h, job_pipeline.h). Tasks that are still to come count: before the plan
// two a cell, to fill and to assemble; then one, until it assembles. So do tasks that are held back (kMostTasksOut).
double ShareDone(std::string_view phase, int64_t cells, int64_t cells_done, int64_t tasks, int64_t tasks_done);

// Not thread-safe but for the metrics themselves: call it under the coordinator's lock.
class JobMetrics {
 public:
  // Jobs that run have one of so many names in the metrics, by which a dashboard tells them apart.
  static constexpr size_t kSlots = 16;

  explicit JobMetrics(MetricsRegistry& registry);

  void Started(const Job& job);
  void Ended(const Job& job, const absl::Status& error);
  // Counts how a job ended, here or in an earlier process. No effect for one that is not over.
  void CountEnd(const Job& job);

  // Sets the gauges: O(jobs that run).
  void Show(const CoordinatorState& state, absl::Time now);
  // From 1; 0 if the job has none.
  int32_t SlotOf(const std::string& job) const;

 private:
  struct Slot {
    std::string job;  // "": free
    Gauge* share;
    Gauge* age;
    Gauge* tasks_running;
  };
  void CountProgress(const Job& job);

  std::array<Slot, kSlots> slots_;
  std::array<Counter*, 5> ended_;  // by state
  std::array<Histogram*, 5> seconds_;
  Histogram* queue_seconds_;
  Counter* holes_filled_;
  Counter* triangles_;
  Counter* cells_done_;
  Counter* output_mismatches_;
  std::map<std::string, Progress> counted_;  // what is in the counters of the jobs that run
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_JOB_METRICS_H_
