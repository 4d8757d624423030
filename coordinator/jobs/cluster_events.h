// What happens in a cluster, for those who look after it. It is told by a line of the log and a count for each job,
// failed attempt and worker.
#ifndef TILEMEND_COORDINATOR_JOBS_CLUSTER_EVENTS_H_
#define TILEMEND_COORDINATOR_JOBS_CLUSTER_EVENTS_H_

#include <string>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "common/metrics/metrics.h"
#include "common/util/log.h"
#include "coordinator/jobs/job_metrics.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/state/coordinator_state.h"

namespace tilemend {

// Not thread-safe but for the log and the metrics themselves: call it under the coordinator's lock.
class ClusterEvents {
 public:
  // All must outlive this.
  ClusterEvents(MetricsRegistry& registry, JobMetrics& jobs, Log& log);

  void JobCreated(const Job& job, const JobSpec& spec, const JobOrigin& origin);
  void JobRestored(const Job& job, const JobOrigin& origin);
  void JobStarted(const Job& job, const JobOrigin& origin);
  void JobEnded(const Job& job, const JobOutcome& outcome, const absl::Status& error, const JobOrigin& origin);
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

 private:
  Log& log_;
  JobMetrics& jobs_;
  Counter* workers_came_;
  Counter* workers_lost_;
  absl::Time last_refusal_ = absl::InfinitePast();  // that has a line
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_CLUSTER_EVENTS_H_
