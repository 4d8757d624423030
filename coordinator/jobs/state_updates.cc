#include "coordinator/jobs/state_updates.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {

absl::StatusOr<Effects> StateUpdates::Apply(const Event& event, TaskContents contents) {
  TILEMEND_ASSIGN_OR_RETURN(Effects effects, cluster_.state.Apply(event));
  for (const Stage stage : effects.retried) cluster_.metrics.Retried(stage);
  for (const StruckTask& task : effects.struck) {
    journal_.PutLoss(task);
    cluster_.events.AttemptLost(task, cluster_.jobs.at(task.key.job).origin);
  }
  for (const StruckTask& task : effects.relieved) journal_.PutLoss(task);
  for (const SettledTask& task : effects.settled) {
    std::optional<std::string> content;
    if (!contents.empty()) {
      content = std::move(contents.front());
      contents.pop_front();
    }
    Settle(task, std::move(content));
  }
  for (const Contradicted& c : effects.contradicted) {
    Warn(c.key.job,
         absl::StrCat("worker ", Printable(c.worker), " could not do cell ", ToString(c.cell), ", stage ",
                      std::string(StageName(c.stage)), ", which worker ", Printable(c.by), " did: ", c.reason));
  }
  if (!effects.retried.empty() || !effects.settled.empty()) cluster_.Changed();
  TakeVerdicts(effects);
  for (const Revoked& revoked : effects.revoked) Revoke(revoked);
  return effects;
}

void StateUpdates::Revoke(const Revoked& revoked) {
  const JobEntry& entry = cluster_.jobs.at(revoked.job);
  // First: from here on the runner takes no result any more.
  if (entry.runner != nullptr) entry.runner->inbox().Fail(BegunAgain());
  journal_.DropResults(revoked);
  cluster_.options.log->Warn("results of a worker are computed again",
                             {{"job", revoked.job},
                              {"trace", entry.origin.trace},
                              {"worker", revoked.worker},
                              {"tasks", static_cast<int64_t>(revoked.tasks.size())}});
}

void StateUpdates::Settle(const SettledTask& task, std::optional<std::string> content) {
  if (!task.known) {
    cluster_.metrics.Settled(task, cluster_.options.clock());
    if (!IsBackground(task.stage)) journal_.PutResult(task, content);  // of others the job makes notes
  }
  JobEntry& entry = cluster_.jobs.at(task.key.job);
  entry.board.TaskSettled(task.cell, task.stage, task.error);
  JobRunner* runner = entry.runner.get();
  if (runner != nullptr) runner->inbox().Deliver(task, std::move(content));
}

void StateUpdates::TakeVerdicts(const Effects& effects) {
  if (effects.suspected.empty() && effects.set_aside.empty() && effects.cleared.empty()) return;
  for (const Blamed& blamed : effects.set_aside) {
    cluster_.trust.SetAside(blamed.worker, blamed.reason);
    cluster_.journal->PutSetAside({blamed.worker, blamed.reason});
    cluster_.events.WorkerSetAside(blamed.worker, blamed.reason);
  }
  for (const Blamed& blamed : effects.suspected) {
    cluster_.trust.Suspect(blamed.worker, blamed.reason);
    cluster_.events.WorkerSuspected(blamed.worker, blamed.reason);
  }
  for (const std::string& worker : effects.cleared) {
    if (cluster_.trust.Clear(worker)) cluster_.events.WorkerCleared(worker);
  }
  cluster_.metrics.ShowTrust(cluster_.trust.Count());
  cluster_.work_changed.notify_all();
  for (const auto* blamed : {&effects.set_aside, &effects.suspected}) {
    for (const auto& [worker, reason] : *blamed) Apply(WorkerLeft{worker}).IgnoreError();  // others do what it holds
  }
}

void StateUpdates::Warn(const std::string& job, const std::string& warning) {
  const Job* warned = cluster_.state.FindJob(job);
  const uint64_t before = warned == nullptr ? 0 : warned->version;
  if (!Apply(JobWarned{job, warning}).ok() || warned->version == before) return;
  cluster_.job_changed.notify_all();
  if (!cluster_.jobs.at(job).completed) journal_.PutJob(*warned, false);  // else its end is put down already
}

}  // namespace tilemend
