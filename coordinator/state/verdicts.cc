#include "coordinator/state/verdicts.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"

namespace tilemend {

bool AddRefusal(int32_t max_refusals, const TaskFailed& event, Job& job, Task& task) {
  const bool agreed = std::any_of(task.refused.begin(), task.refused.end(), [&](const auto& refused) {
    return refused.first != event.worker && refused.second.digest == event.refused;
  });
  const bool is_new =
      task.refused.insert_or_assign(event.worker, Refusal{event.refused, std::string(event.error.message())}).second;
  if (is_new) ++job.doubts.refusals[event.worker];
  task.refused_at = event.time;
  job.doubts.tasks.insert(task.id);
  return agreed || static_cast<int32_t>(task.refused.size()) >= max_refusals;
}

void SuspectRefused(const Job& job, const TaskFailed& event, Effects& effects) {
  for (const auto& [worker, count] : job.doubts.refusals) {
    if (worker != event.worker) effects.cleared.push_back(worker);
  }
  // Without another to try it there is nothing to be had by taking this one away.
  if (effects.cleared.empty() && event.another) {
    effects.suspected.push_back({event.worker, std::string(event.error.message())});
  }
}

void JudgeRefusals(Job& job, Task& task, Effects& effects) {
  job.doubts.tasks.erase(task.id);
  for (auto& [worker, refusal] : std::exchange(task.refused, {})) {
    std::map<std::string, int64_t>& refusals = job.doubts.refusals;
    if (const auto count = refusals.find(worker); --count->second == 0) refusals.erase(count);
    if (task.state == TaskState::kCommitted) {
      effects.set_aside.push_back({worker, std::move(refusal.reason)});
    } else {
      effects.cleared.push_back(worker);
    }
  }
}

void ForgetRefusals(Job& job, Effects& effects) {
  for (const auto& [worker, count] : std::exchange(job.doubts.refusals, {})) {
    if (!job.doubts.disproved.contains(worker)) effects.cleared.push_back(worker);
  }
  job.doubts.tasks.clear();
}

absl::StatusOr<Effects> Disprove(int32_t max_refusals, const WorkerDisproved& event, Job& job) {
  std::map<std::string, Disproof>& disproved = job.doubts.disproved;
  const bool are_too_many = static_cast<int32_t>(disproved.size()) + 1 >= max_refusals;
  // A worker that is disproved again had no other beside it.
  if (event.worker.empty() || are_too_many || disproved.contains(event.worker)) {
    return absl::FailedPreconditionError(absl::StrCat("jobs/", job.id, ": ", event.reason));
  }
  disproved[event.worker] = {event.reason, event.another};
  Effects effects;
  if (event.another) effects.suspected.push_back({event.worker, event.reason});
  effects.revoked.push_back({job.id, event.worker, job.given.Revoke(event.worker)});
  return effects;
}

void JudgeDisproved(Job& job, JobState state, Effects& effects) {
  const bool is_good = state == JobState::kDone || state == JobState::kPartial;
  for (auto& [worker, disproof] : std::exchange(job.doubts.disproved, {})) {
    if (is_good && disproof.others_do_it) {
      effects.set_aside.push_back({worker, std::move(disproof.reason)});
    } else {
      effects.cleared.push_back(worker);
    }
  }
}

void RevokeOfSetAside(JobTable& jobs, Effects& effects) {
  for (const Blamed& blamed : effects.set_aside) {
    for (const auto& [number, id] : jobs.running()) {
      std::vector<int64_t> tasks = jobs.Find(id)->given.Revoke(blamed.worker);
      if (!tasks.empty()) effects.revoked.push_back({id, blamed.worker, std::move(tasks)});
    }
  }
}

void KeepDisprovedSuspected(const JobTable& jobs, Effects& effects) {
  std::erase_if(effects.cleared, [&](const std::string& worker) {
    return std::any_of(jobs.running().begin(), jobs.running().end(), [&](const auto& job) {
      const auto& disproved = jobs.Find(job.second)->doubts.disproved;
      const auto found = disproved.find(worker);
      return found != disproved.end() && found->second.others_do_it;
    });
  });
}

}  // namespace tilemend
