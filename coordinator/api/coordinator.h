// The coordinator: its jobs and workers, its threads, and the handlers of all calls. Nothing here knows gRPC.
#ifndef TILEMEND_COORDINATOR_API_COORDINATOR_H_
#define TILEMEND_COORDINATOR_API_COORDINATOR_H_

#include <memory>

#include "absl/status/statusor.h"
#include "common/metrics/metrics.h"
#include "coordinator/api/blobs_handler.h"
#include "coordinator/api/cluster_handler.h"
#include "coordinator/api/jobs_handler.h"
#include "coordinator/api/watch_handler.h"
#include "coordinator/api/work_handler.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/coordinator_options.h"
#include "coordinator/jobs/housekeeping.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/job_runs.h"
#include "coordinator/jobs/restore_jobs.h"
#include "coordinator/jobs/state_updates.h"

namespace tilemend {

// The calls of clients and workers, a handler for each group.
struct CallHandlers {
  JobsHandler jobs;
  WatchHandler watch;
  WorkHandler work;
  BlobsHandler blobs;
  ClusterHandler cluster;
};

// Thread-safe.
class Coordinator {
 public:
  // Goes on with the jobs of the journal. Errors: kInvalidArgument for a lease that is too short, kPermissionDenied if
  // the work folder cannot be used, and those of JobRestorer.
  static absl::StatusOr<std::unique_ptr<Coordinator>> Create(CoordinatorOptions options, PipelineFactory factory,
                                                             MetricsRegistry& metrics);
  // Leaves jobs as they are: with the journal they go on.
  ~Coordinator();

  CallHandlers& calls() { return calls_; }

  // Gives up overdue leases and silent workers, and lets go of what belongs to jobs that are over.
  void Tick() { housekeeping_.Tick(); }

  // Ends every wait: calls return at once from now on, jobs stay as they are. For a graceful end of the server.
  void StopWaiting() { cluster_.StopWaiting(); }

 private:
  Coordinator(CoordinatorOptions options, PipelineFactory factory, MetricsRegistry& metrics);

  // Each uses those before it.
  Cluster cluster_;
  const JobJournal journal_;
  StateUpdates updates_;
  JobRuns runs_;
  CallHandlers calls_;
  JobRestorer restorer_;
  Housekeeping housekeeping_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_COORDINATOR_H_
