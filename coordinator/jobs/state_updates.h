// Events on the state machine, and all that follows from each.
#ifndef TILEMEND_COORDINATOR_JOBS_STATE_UPDATES_H_
#define TILEMEND_COORDINATOR_JOBS_STATE_UPDATES_H_

#include <string>

#include "absl/status/statusor.h"
#include "coordinator/jobs/cluster.h"
#include "coordinator/jobs/job_journal.h"
#include "coordinator/state/coordinator_state.h"
#include "coordinator/state/event.h"

namespace tilemend {

// Applies events. What an event changed goes into the journal, the metrics and the log, and settled tasks go to the
// runners of their jobs. All methods need the lock.
class StateUpdates {
 public:
  // Both must outlive this.
  StateUpdates(Cluster& cluster, const JobJournal& journal) : cluster_(cluster), journal_(journal) {}

  // `contents`: outputs of the tasks that the event settles. The errors of CoordinatorState::Apply.
  absl::StatusOr<Effects> Apply(const Event& event, TaskContents contents = {});
  // Adds a warning to a job, once.
  void Warn(const std::string& job, const std::string& warning);

 private:
  void Settle(const SettledTask& task, std::optional<std::string> content);
  // The job is done again without what the worker gave.
  void Revoke(const Revoked& revoked);
  // Which workers get no more tasks, and which get tasks again.
  void TakeVerdicts(const Effects& effects);

  Cluster& cluster_;
  const JobJournal& journal_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_STATE_UPDATES_H_
