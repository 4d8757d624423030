#include "worker/service/held_tasks.h"

#include <algorithm>
#include <utility>

#include "common/rpc/limits.h"

namespace tilemend {

void HeldTasks::Add(v1::Task task) {
  const uint64_t token = task.ref().attempt_token();
  if (held_.contains(token) || finished_.contains(token)) return;
  auto held = std::make_shared<HeldTask>();
  held->task = std::move(task);
  held_[token] = held;
  ready_.push_back(std::move(held));
}

std::shared_ptr<HeldTask> HeldTasks::TakeNext() {
  if (ready_.empty()) return nullptr;
  std::shared_ptr<HeldTask> next = std::move(ready_.front());
  ready_.pop_front();
  return next;
}

void HeldTasks::Finish(const HeldTask& held, const v1::FinishedTask& report) {
  const uint64_t token = held.task.ref().attempt_token();
  WorkerMetrics::PerStage& metrics = metrics_.Of(static_cast<Stage>(held.task.stage()));
  held_.erase(token);
  if (held.dropped) {
    metrics.cancelled->Increment();
  } else {
    (report.has_output() ? metrics.finished : metrics.failed)->Increment();
    finished_[token] = report;
  }
}

void HeldTasks::Drop(uint64_t token) {
  finished_.erase(token);
  const auto it = held_.find(token);
  if (it == held_.end()) return;
  it->second->dropped = true;
  it->second->cancel.Cancel();
  if (std::erase(ready_, it->second) > 0) held_.erase(it);
}

void HeldTasks::DropTasks() {
  while (const auto waiting = TakeNext()) held_.erase(waiting->task.ref().attempt_token());
  for (const auto& [token, held] : held_) held->dropped = true;
  CancelAll();
}

void HeldTasks::CancelAll() {
  for (const auto& [token, held] : held_) held->cancel.Cancel();
}

void HeldTasks::AddTo(v1::SyncRequest& request) const {
  int threads = threads_;
  for (const auto& [token, held] : held_) {
    if (held->dropped) {
      --threads;  // still busy with it
    } else {
      *request.add_held() = held->task.ref();
      if (held->begun) request.add_begun(token);
    }
  }
  request.set_threads(std::max(threads, 0));
  request.set_prefetch(prefetch_);
  size_t bytes = 0;
  for (const auto& [token, finished] : finished_) {
    bytes += finished.output().content().size();
    if (bytes <= kMaxInlineBytesPerSync) {
      *request.add_finished() = finished;
    } else {
      *request.add_held() = finished.ref();  // still held in the coordinator's eyes
    }
  }
}

size_t HeldTasks::finished_bytes() const {
  size_t bytes = 0;
  for (const auto& [token, finished] : finished_) bytes += finished.output().content().size();
  return bytes;
}

}  // namespace tilemend
