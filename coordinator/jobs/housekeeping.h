// Periodic work: lost workers, leases that have expired, jobs that are over.
#ifndef TILEMEND_COORDINATOR_JOBS_HOUSEKEEPING_H_
#define TILEMEND_COORDINATOR_JOBS_HOUSEKEEPING_H_

#include <functional>
#include <thread>
#include <utility>

#include "absl/time/time.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/state_updates.h"

namespace tilemend {

// Gives up overdue leases and silent workers, and frees what belongs to jobs that are over.
class Housekeeping {
 public:
  // `on_tick` is called by each Tick with the lock held. The references must outlive this.
  Housekeeping(Cluster& cluster, StateUpdates& updates, std::function<void(absl::Time)> on_tick)
      : cluster_(cluster), updates_(updates), on_tick_(std::move(on_tick)) {}
  ~Housekeeping() { StopTicking(); }

  // Calls Tick from a thread of its own: every quarter of a lease, and once a second or more often.
  void StartTicking();
  // Waits for the thread, which ends after Cluster::StopWaiting.
  void StopTicking();
  // Takes the lock.
  void Tick();

 private:
  void TickLoop();
  // With the lock held.
  void ForgetOldJobs(absl::Time now);

  Cluster& cluster_;
  StateUpdates& updates_;
  const std::function<void(absl::Time)> on_tick_;
  bool may_lose_ = true;  // silent workers count as lost; guarded by the lock
  std::thread ticker_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_HOUSEKEEPING_H_
