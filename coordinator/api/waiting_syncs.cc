#include "coordinator/api/waiting_syncs.h"

#include "common/rpc/limits.h"

namespace tilemend {

WaitingSyncs::WaitingSyncs(Cluster& cluster, Try try_answer)
    : cluster_(cluster), try_answer_(std::move(try_answer)), thread_([this] { Run(); }) {}

WaitingSyncs::~WaitingSyncs() {
  {
    const ClusterLock lock(cluster_.mutex);
    quits_ = true;
    cluster_.work_changed.notify_all();
    cluster_.work_changed.Wake();
  }
  thread_.join();
}

void WaitingSyncs::Add(std::shared_ptr<WorkerSync> sync) {
  const uint64_t number = ++last_;
  if (waiting_.empty()) seen_ = cluster_.work_changed.count();
  deadlines_.emplace(sync->deadline, number);
  workers_.emplace(sync->request.worker(), number);
  if (deadlines_.begin()->second == number) cluster_.work_changed.Wake();
  waiting_.emplace(number, std::move(sync));
}

void WaitingSyncs::TryCallsOf(const std::string& worker) {
  std::set<uint64_t> numbers;
  for (auto at = workers_.lower_bound({worker, 0}); at != workers_.end() && at->first == worker; ++at) {
    numbers.insert(at->second);
  }
  for (const uint64_t number : numbers) TryOne(number);
}

// Others get the lock between two calls.
void WaitingSyncs::Run() {
  ClusterLock lock(cluster_.mutex);
  while (!quits_ || !waiting_.empty()) {
    const bool has_changed = cluster_.work_changed.count() != std::exchange(seen_, cluster_.work_changed.count());
    const SteadyTime now = std::chrono::steady_clock::now();
    for (const uint64_t number : has_changed ? All() : Due(now)) {
      TryOne(number);
      lock.unlock();
      lock.lock();
    }
    const SteadyTime idle = std::chrono::steady_clock::now() + absl::ToChronoMilliseconds(kMaxPoll);
    if (!waiting_.empty()) {
      cluster_.work_changed.WaitUntil(lock, seen_, deadlines_.begin()->first);
    } else if (!quits_) {
      cluster_.work_changed.SleepUntil(lock, idle);
    }
  }
}

std::set<uint64_t> WaitingSyncs::Due(SteadyTime now) const {
  std::set<uint64_t> due;
  for (auto at = deadlines_.begin(); at != deadlines_.end() && at->first <= now; ++at) due.insert(at->second);
  return due;
}

std::set<uint64_t> WaitingSyncs::All() const {
  std::set<uint64_t> all;
  for (const auto& [number, sync] : waiting_) all.insert(all.end(), number);
  return all;
}

void WaitingSyncs::TryOne(uint64_t number) {
  const auto found = waiting_.find(number);
  if (found == waiting_.end()) return;  // it has been answered meanwhile
  const std::shared_ptr<WorkerSync> sync = found->second;
  if (!try_answer_(sync)) return;
  deadlines_.erase({sync->deadline, number});
  workers_.erase({sync->request.worker(), number});
  waiting_.erase(number);
}

}  // namespace tilemend
