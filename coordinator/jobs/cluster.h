// The jobs and workers of a coordinator in memory, and the lock on them.
//
// Whatever the coordinator has told anybody is durable. Events take effect in memory and go into the journal under one
// lock. Every answer to a call, every task for a worker and every call of a pipeline waits until the journal has what
// was put before (AnswerWhenDurable).
#ifndef TILEMEND_COORDINATOR_JOBS_CLUSTER_H_
#define TILEMEND_COORDINATOR_JOBS_CLUSTER_H_

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "common/metrics/metrics.h"
#include "common/util/files.h"
#include "coordinator/jobs/cluster_events.h"
#include "coordinator/jobs/coordinator_metrics.h"
#include "coordinator/jobs/coordinator_options.h"
#include "coordinator/jobs/job_metrics.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/job_runner.h"
#include "coordinator/jobs/worker_trust.h"
#include "coordinator/journal/journal.h"
#include "coordinator/state/cell_board.h"
#include "coordinator/state/coordinator_state.h"
#include "coordinator/state/task_choice.h"
#include "coordinator/store/blob_folder.h"

namespace tilemend {

// What belongs to a job beside its state and its tasks.
struct JobEntry {
  JobSpec spec;
  JobOrigin origin;
  std::string out_key;  // OutKeyOf(spec)
  JobOutcome outcome;
  absl::Status error;
  std::shared_ptr<BlobFolder> blobs;
  std::unique_ptr<JobRunner> runner;
  std::shared_ptr<const SceneSight> sight;  // while it runs
  CellBoard board;                          // empty for one that was over when this process began
  bool completed = false;                   // its output is, and its end is in the journal
  absl::Time ended;                         // if it is
  bool resuming = false;                    // all its tasks so far were settled by an earlier process
  bool began_again = false;                 // results of before are kept, and may be reported once more
};

// What a worker said of itself.
struct WorkerCaller {
  uint64_t sequence = 0;  // of its last call
  std::string secret;
  std::string release;
  std::string identity;
  absl::Time first_seen;
  int calls = 0;  // whose results are being checked
  // When it left; a call that comes late must not make it known again.
  std::optional<absl::Time> left = std::nullopt;
};

using ClusterLock = std::unique_lock<std::mutex>;

// Wakes the one thread that looks after all calls which wait for some kind of change. With the lock held.
class ChangeSignal {
 public:
  void notify_all() {
    ++count_;
    if (!sleeps_) changed_.notify_all();
  }
  // How often it was told of a change.
  uint64_t count() const { return count_; }
  // Ends a wait although nothing has changed.
  void Wake() { changed_.notify_all(); }
  // Waits for a change after the first `seen`, or until `deadline`, or less.
  void WaitUntil(ClusterLock& lock, uint64_t seen, std::chrono::steady_clock::time_point deadline) {
    if (count_ == seen) changed_.wait_until(lock, deadline);
  }
  // Waits until `deadline`, or less; a change does not end it, only Wake.
  void SleepUntil(ClusterLock& lock, std::chrono::steady_clock::time_point deadline) {
    sleeps_ = true;
    changed_.wait_until(lock, deadline);
    sleeps_ = false;
  }

 private:
  uint64_t count_ = 0;
  bool sleeps_ = false;
  std::condition_variable changed_;
};

// The methods need the lock, except for the constructor and StopWaiting.
struct Cluster {
  // `start` has a clock and a journal.
  Cluster(CoordinatorOptions start, MetricsRegistry& registry);

  // `name` is jobs/ID. kInvalidArgument (INVALID_NAME), kNotFound (JOB_NOT_FOUND).
  absl::StatusOr<const Job*> JobNamed(const std::string& name) const;
  // Which worker may work on which job. Valid as long as the cluster.
  MayWork MayWorkNow() const;
  void ShowMetrics();
  // Wakes the calls that wait for a change.
  void Changed();
  // Every wait ends, now and from now on; jobs stay as they are. Takes the lock.
  void StopWaiting();

  const CoordinatorOptions options;
  const std::shared_ptr<Journal> journal;
  CoordinatorMetrics metrics;

  std::mutex mutex;           // guards all below
  ChangeSignal work_changed;  // tasks were added or leases ended
  ChangeSignal job_changed;
  std::condition_variable stop_changed;
  bool stopping = false;
  JobMetrics job_metrics;
  ClusterEvents events;
  CoordinatorState state;
  std::map<std::string, JobEntry> jobs;         // by id
  std::map<std::string, WorkerCaller> callers;  // workers, by id
  WorkerTrust trust;
};

// Workers that have reported results which are being checked. They do not count as silent.
std::set<std::string> WorkersBeingChecked(const Cluster& cluster);

// What `make` returns under the lock, once all that it was made from is durable. Without the lock.
template <class Make>
auto AnswerWhenDurable(Cluster& cluster, Make make) {
  ClusterLock lock(cluster.mutex);
  auto answer = make();
  lock.unlock();
  cluster.journal->Await();
  return answer;
}

// Whether outputs must be on the disk before they are committed. Without the lock.
Sync OutputSync(const Cluster& cluster);

// The folder of the blobs of a job. Without the lock.
std::string BlobsPathOf(const Cluster& cluster, const std::string& job);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_CLUSTER_H_
