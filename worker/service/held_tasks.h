// The tasks that a worker holds, and their results until the coordinator has acknowledged them.
#ifndef TILEMEND_WORKER_SERVICE_HELD_TASKS_H_
#define TILEMEND_WORKER_SERVICE_HELD_TASKS_H_

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>

#include "common/util/cancel_token.h"
#include "tilemend/v1/work.pb.h"
#include "worker/service/worker_metrics.h"

namespace tilemend {

struct HeldTask {
  v1::Task task;
  CancelToken cancel;
  bool dropped = false;  // still runs, but is no longer this worker's
  std::atomic<bool> begun = false;
};

// Not thread-safe. Tasks are named by their attempt tokens.
class HeldTasks {
 public:
  // As in WorkerOptions. Counts in `metrics` how tasks end.
  HeldTasks(int threads, int prefetch, WorkerMetrics& metrics)
      : threads_(threads), prefetch_(prefetch), metrics_(metrics) {}

  // No effect for a task that is here, running or finished.
  void Add(v1::Task task);
  // The task that was added first of those that nobody has taken to run it; null if there is none.
  std::shared_ptr<HeldTask> TakeNext();
  // The task does not run any more. Keeps the report, unless the task was dropped.
  void Finish(const HeldTask& held, const v1::FinishedTask& report);
  void Forget(uint64_t token) { held_.erase(token); }
  void Acknowledge(uint64_t token) { finished_.erase(token); }

  // Forgets the task and its result, or cancels it if it runs.
  void Drop(uint64_t token);
  // Likewise all tasks; results stay.
  void DropTasks();
  // Tasks stay this worker's.
  void CancelAll();

  // Adds what is held, begun and finished, and for how many tasks there is room. Results that do not fit in one call
  // are named as held.
  void AddTo(v1::SyncRequest& request) const;

  // Whether there are tasks for all threads and half of those that are to wait for one.
  bool is_busy() const { return std::ssize(held_) > threads_ + prefetch_ / 2; }
  bool has_next() const { return !ready_.empty(); }
  bool is_empty() const { return held_.empty() && finished_.empty(); }
  size_t finished_bytes() const;  // of results

 private:
  const int threads_;
  const int prefetch_;
  WorkerMetrics& metrics_;
  std::map<uint64_t, std::shared_ptr<HeldTask>> held_;  // dropped ones too
  std::deque<std::shared_ptr<HeldTask>> ready_;
  std::map<uint64_t, v1::FinishedTask> finished_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_HELD_TASKS_H_
