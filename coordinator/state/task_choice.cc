#include "coordinator/state/task_choice.h"

#include <algorithm>
#include <utility>

namespace tilemend {
namespace {

// Of each job, the oldest first: more cannot be worth it at once.
constexpr int kMostStragglers = 16;

// What a task of a stage is taken to need while none of the job's has been done: a worker that takes all of them and
// does none is not waited for until its attempts are over.
constexpr absl::Duration kUnknownTime = absl::Minutes(1);

// A worker says once a second which tasks it has begun. What it holds and has not begun for longer goes to one that has
// a thread for it: workers may hold more than they do.
constexpr absl::Duration kTimeToBegin = absl::Seconds(5);

// Not whether it has a thread for it now.
bool MayTry(const WorkerRecord& worker, const Job& job, const Task& task, const MayWork& may) {
  return !worker.draining && !task.refused.contains(worker.id) && may(worker.id, job.id);
}

class TaskChooser {
 public:
  TaskChooser(const CoordinatorState& state, const WorkerRecord& worker, absl::Time now, const MayWork& may)
      : state_(state), worker_(worker), now_(now), may_(may) {
    free_ = worker.threads - std::min<size_t>(worker.threads, worker.held.size());
  }

  std::vector<TaskKey> Choose() {
    if (HoldsLastChance()) return {};
    std::vector<Share> shares;
    for (const auto& [number, id] : state_.running()) {
      const Job& job = *state_.FindJob(id);
      if (job.counts.pending > 0 && !job.paused && may_(worker_.id, id))
        shares.push_back({&job, &job.pending.first, job.pending.first.begin(), job.counts.leased});
    }
    while (chosen_.size() < free_ && !shares.empty()) {
      const auto first = std::min_element(shares.begin(), shares.end());
      if (!TakeNext(*first)) shares.erase(first);
    }
    if (!is_closed_) AddSpares(shares);
    if (!is_closed_) AddStragglers();
    return std::move(chosen_);
  }

 private:
  struct Share {
    const Job* job;
    const std::set<int64_t>* queue;
    std::set<int64_t>::const_iterator next;
    int64_t leases;

    // Whether its turn comes before that of another.
    bool operator<(const Share& other) const {
      return std::pair(-job->priority, leases) < std::pair(-other.job->priority, other.leases);
    }
  };

  bool IsLastChance(const Task& task) const {
    const int32_t most = state_.options().quarantine_after;
    return most > 1 && static_cast<int32_t>(task.lost_workers.size()) + 1 >= most;
  }

  bool HoldsLastChance() const {
    return std::any_of(worker_.held.begin(), worker_.held.end(),
                       [this](const TaskKey& key) { return IsLastChance(*state_.FindTask(key)); });
  }

  // One that failed waits for the others alone.
  bool MustWait(const Task& task) const {
    return now_ < task.not_before && (task.failed_by.empty() || task.returned_by.contains(worker_.id));
  }

  // Whether it is left to others. After a machine error it is so only for a while: the others may be stuck.
  bool IsLeftToOthers(const Task& task) const {
    if (!task.returned_by.contains(worker_.id)) return false;
    const bool by_machine_error = task.returns > 0 && task.failed_by.empty() && task.lost_workers.empty();
    return !by_machine_error || now_ < task.not_before + state_.options().wait_for_another;
  }

  bool MayHave(const Job& job, const Task& task) const {
    return !MustWait(task) && !task.refused.contains(worker_.id) &&
           !(IsLeftToOthers(task) && HasAnother(state_, worker_.id, job, task, may_));
  }

  // Chooses the share's next task; false if it has none.
  bool TakeNext(Share& share) {
    const Job& job = *share.job;
    while (share.next != share.queue->end() && !MayHave(job, job.tasks.at(*share.next))) ++share.next;
    if (share.next == share.queue->end()) {
      if (share.queue == &job.pending.background) return false;
      share.queue = &job.pending.background;
      share.next = share.queue->begin();
      return TakeNext(share);
    }
    if (!IsLastChance(job.tasks.at(*share.next))) {
      chosen_.push_back({job.id, *share.next++});
      ++share.leases;
      return true;
    }
    // Alone or not at all. A worker that holds others takes nothing more before it, so that it comes to its turn.
    if (worker_.held.empty() && chosen_.empty()) chosen_.push_back({job.id, *share.next});
    is_closed_ = true;
    free_ = chosen_.size();
    return true;
  }

  // Beyond its threads, while more tasks wait than the other workers together can hold.
  void AddSpares(std::vector<Share>& shares) {
    if (worker_.threads == 0 || worker_.prefetch == 0) return;
    size_t others = 0, pending = 0;
    for (const auto& [id, other] : state_.workers()) {
      if (id != worker_.id && !other.draining) others += other.threads + other.prefetch;
    }
    for (const Share& share : shares) pending += static_cast<size_t>(share.job->counts.pending);
    const size_t most = worker_.threads + worker_.prefetch;
    while (worker_.held.size() + chosen_.size() < most && chosen_.size() + others < pending && !shares.empty()) {
      const auto first = std::min_element(shares.begin(), shares.end());
      if (!TakeNext(*first)) shares.erase(first);
      if (is_closed_) return;
    }
  }

  void AddStragglers() {
    for (const auto& [number, id] : state_.running()) {
      if (chosen_.size() >= free_) return;
      const Job& job = *state_.FindJob(id);
      if (job.alone.empty() || job.paused || !may_(worker_.id, id)) continue;
      int looked_at = 0;
      for (const auto& [since, number_of_task] : job.alone) {
        if (chosen_.size() >= free_ || ++looked_at > kMostStragglers) break;
        const Task& task = job.tasks.at(number_of_task);
        if (Straggles(job, task, since)) chosen_.push_back({id, number_of_task});
      }
    }
  }

  bool Straggles(const Job& job, const Task& task, absl::Time since) const {
    if (LeaseOf(task, worker_.id) != nullptr) return false;
    // A task that workers were lost with is not to take two at once.
    if (!task.lost_workers.empty() || task.refused.contains(worker_.id) || IsLeftToOthers(task)) {
      return false;
    }
    if (!task.leases.front().begun) return now_ - since > kTimeToBegin;
    const StateOptions& options = state_.options();
    const auto time = job.times.find(task.stage);
    const absl::Duration usual = time == job.times.end() ? kUnknownTime : time->second.total / time->second.tasks;
    return now_ - since > std::max(options.least_straggling, usual * options.straggler_factor);
  }

  const CoordinatorState& state_;
  const WorkerRecord& worker_;
  const absl::Time now_;
  const MayWork& may_;
  size_t free_ = 0;
  bool is_closed_ = false;  // nothing is to be taken beside what is chosen
  std::vector<TaskKey> chosen_;
};

}  // namespace

bool MayAlways(const std::string&, const std::string&) { return true; }

std::vector<TaskKey> ChooseTasks(const CoordinatorState& state, const std::string& worker, absl::Time now,
                                 const MayWork& may) {
  const WorkerRecord* record = state.FindWorker(worker);
  if (record == nullptr || record->draining || now < record->rests_until) return {};
  return TaskChooser(state, *record, now, may).Choose();
}

bool HasAnother(const CoordinatorState& state, const std::string& worker, const Job& job, const Task& task,
                const MayWork& may) {
  return std::any_of(state.workers().begin(), state.workers().end(), [&](const auto& entry) {
    const auto& [id, other] = entry;
    return id != worker && other.threads > 0 && !task.returned_by.contains(id) && MayTry(other, job, task, may);
  });
}

bool HasOtherWorker(const CoordinatorState& state, const std::string& worker, const std::string& job,
                    const MayWork& may) {
  return std::any_of(state.workers().begin(), state.workers().end(), [&](const auto& entry) {
    const auto& [id, other] = entry;
    return id != worker && other.threads > 0 && !other.draining && may(id, job);
  });
}

std::vector<Event> Overdue(const CoordinatorState& state, absl::Time now, absl::Duration silence,
                           const std::set<std::string>& heard) {
  std::vector<Event> events;
  for (const auto& [id, worker] : state.workers()) {
    if (heard.contains(id)) continue;
    if (worker.last_seen + silence < now) {
      events.emplace_back(WorkerLost{id});
      continue;
    }
    // First the tasks that the worker has not begun: their loss is no failed attempt.
    for (const bool begun : {false, true}) {
      for (const TaskKey& key : worker.held) {
        const Lease& lease = *LeaseOf(*state.FindTask(key), id);
        const bool too_long = lease.since + state.options().longest_attempt < now;
        const bool is_over = lease.deadline < now || too_long;
        if (is_over && lease.begun == begun) events.emplace_back(LeaseExpired{key, id, lease.token});
      }
    }
  }
  return events;
}

std::vector<Event> Abandoned(const CoordinatorState& state, absl::Time now, const MayWork& may) {
  std::vector<Event> events;
  for (const auto& [number, id] : state.running()) {
    const Job& job = *state.FindJob(id);
    for (const int64_t task_id : job.doubts.tasks) {
      const Task& task = job.tasks.at(task_id);
      const bool waits = now < task.refused_at + state.options().wait_for_another;
      if (task.state != TaskState::kPending || waits) continue;
      const bool has_taker = std::any_of(state.workers().begin(), state.workers().end(),
                                         [&](const auto& entry) { return MayTry(entry.second, job, task, may); });
      if (!has_taker) events.emplace_back(TaskAbandoned{{id, task_id}});
    }
  }
  return events;
}

}  // namespace tilemend
