// What happens in a cluster, for those who look after it. It is told by a line of the log and a count for each job,
// failed attempt and worker.
#ifndef TILEMEND_COORDINATOR_JOBS_CLUSTER_EVENTS_H_
#define TILEMEND_COORDINATOR_JOBS_CLUSTER_EVENTS_H_

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "common/metrics/metrics.h"
#include "common/util/log.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/state/coordinator_state.h"

namespace tilemend {

// The share of a job that is done, 0 to 1. While not all of its tasks are known, a guess that may fall.
double ShareDone(const Job& job);
// Of a job that runs, by its phase (wave_order.h). Before its plan each cell is expected to be filled and assembled,
// then to be assembled, until it assembles. Tasks that are held back (kMostTasksOut) count.
double ShareDone(std::string_view phase, int64_t cells, int64_t cells_done, int64_t tasks, int64_t tasks_done);

// Not thread-safe but for the log and the metrics themselves: call it under the coordinator's lock.
class ClusterEvents {
 public:
  // Jobs that run have one of so many names in the metrics, by which a dashboard tells them apart.
  static constexpr size_t kSlots = 16;

  ClusterEvents(MetricsRegistry& registry, Log& log);

  void JobCreated(const Job& job, const JobSpec& spec, const JobOrigin& origin);
  void JobRestored(const Job& job, const JobOrigin& origin);
  void JobStarted(const Job& job, const JobOrigin& origin);
  void JobEnded(const Job& job, const JobOutcome& outcome, const absl::Status& error, const JobOrigin& origin);
  // Of one that an earlier process saw end: it counts, and no line says so again.
  void JobRemembered(const Job& job) { Count(job); }
  void AttemptFailed(const Task& task, const std::string& job, const std::string& worker, const JobOrigin& origin,
                     const absl::Status& error);
  // A task went back because its worker was lost.
  void AttemptLost(const StruckTask& task, const JobOrigin& origin);

  void WorkerCame(const WorkerRecord& worker, const std::string& release, const std::string& identity);
  // It speaks another protocol. A line for one of them every ten seconds: they may ask again and again.
  void WorkerRefused(const std::string& worker, const std::string& release, const absl::Status& reason, absl::Time now);
  void WorkerLeft(const std::string& worker);
  void WorkerLost(const WorkerRecord& worker, absl::Time now);
  // It gets no task until it is known whose fault its wrong result is; nobody's; its own.
  void WorkerSuspected(const std::string& worker, const std::string& reason);
  void WorkerCleared(const std::string& worker);
  void WorkerSetAside(const std::string& worker, const std::string& reason);
  void WorkerBlind(const std::string& worker, const std::string& job, const std::string& reason);

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
  void Count(const Job& job);
  void CountProgress(const Job& job);

  Log& log_;
  std::array<Slot, kSlots> slots_;
  std::array<Counter*, 5> ended_;  // by state
  std::array<Histogram*, 5> seconds_;
  Histogram* queue_seconds_;
  Counter* holes_filled_;
  Counter* triangles_;
  Counter* cells_done_;
  Counter* output_mismatches_;
  Counter* workers_came_;
  Counter* workers_lost_;
  absl::Time last_refusal_ = absl::InfinitePast();  // that has a line
  std::map<std::string, Progress> counted_;         // what is in the counters of the jobs that run
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_CLUSTER_EVENTS_H_
