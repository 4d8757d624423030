#include "worker/service/worker_state.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <set>
#include <utility>

#include "common/rpc/limits.h"
#include "common/util/heap.h"

namespace tilemend {

void WorkerState::SetMode(Mode mode) {
  std::lock_guard<std::mutex> lock(mutex_);
  mode_ = std::max(mode_, mode);
  if (mode_ >= Mode::kStopping) tasks_.DropTasks();
  CallNow();
  changed_.notify_all();
}

bool WorkerState::is_running() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return mode_ == Mode::kRunning;
}

void WorkerState::CallNow() {
  if (waiting_call_ != nullptr) waiting_call_->Interrupt();
  news_.notify_one();
}

std::optional<absl::StatusOr<v1::SyncResponse>> WorkerState::Call(SyncCall& call, v1::SyncRequest& request) {
  constexpr std::chrono::milliseconds kRest(100);
  {
    std::unique_lock<std::mutex> lock(mutex_);
    news_.wait_for(lock, kRest, [this] {
      return !tasks_.is_busy() || tasks_.finished_bytes() > kInlineBlobBytes || looks_.has_seen() ||
             mode_ != Mode::kRunning;
    });
    if (mode_ == Mode::kAbandoned) return std::nullopt;
    tasks_.AddTo(request);
    looks_.AddTo(request);
    request.set_draining(mode_ >= Mode::kDraining);
    if (request.finished().empty()) waiting_call_ = &call;
  }
  absl::StatusOr<v1::SyncResponse> response = call.Run(request);
  std::lock_guard<std::mutex> lock(mutex_);
  waiting_call_ = nullptr;
  if (mode_ == Mode::kAbandoned) return std::nullopt;
  return response;
}

bool WorkerState::Take(const v1::SyncRequest& request, v1::SyncResponse response) {
  std::set<uint64_t> kept;
  for (const v1::TaskRef& ref : response.keep()) kept.insert(ref.attempt_token());
  std::lock_guard<std::mutex> lock(mutex_);
  for (const v1::TaskRef& ref : response.acknowledged()) tasks_.Acknowledge(ref.attempt_token());
  for (const v1::TaskRef& ref : request.held()) {
    if (!kept.contains(ref.attempt_token())) tasks_.Drop(ref.attempt_token());
  }
  if (mode_ >= Mode::kStopping) return false;
  looks_.Take(request, response);
  for (v1::Task& task : *response.mutable_start()) tasks_.Add(std::move(task));
  changed_.notify_all();
  return true;
}

bool WorkerState::Pause(absl::Duration pause) {
  std::unique_lock<std::mutex> lock(mutex_);
  const Mode before = mode_;
  const auto is_over = [&] {
    if (mode_ == Mode::kDraining) return tasks_.is_empty();  // nothing to tell: no need to be released
    return mode_ >= Mode::kStopping;                         // it would have told once, and could not
  };
  changed_.wait_for(lock, absl::ToChronoMilliseconds(pause), [&] { return mode_ != before || is_over(); });
  return !is_over();
}

void WorkerState::End() {
  std::lock_guard<std::mutex> lock(mutex_);
  ended_ = true;
  tasks_.CancelAll();
  changed_.notify_all();
}

std::optional<WorkerState::Work> WorkerState::NextWork() {
  constexpr std::chrono::seconds kRest(1);  // as while a large scene is planned
  const auto has_work = [this] { return ended_ || tasks_.has_next() || looks_.has_next(); };
  std::unique_lock<std::mutex> lock(mutex_);
  if (!changed_.wait_for(lock, kRest, has_work)) {
    lock.unlock();
    ReturnHeap();
    lock.lock();
    changed_.wait(lock, has_work);
  }
  if (ended_) return std::nullopt;
  if (auto folders = looks_.TakeNext()) return Work{std::move(folders), nullptr};
  return Work{std::nullopt, tasks_.TakeNext()};
}

bool WorkerState::Finish(const HeldTask& held, const v1::FinishedTask* report) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (report == nullptr) {
    tasks_.Forget(held.task.ref().attempt_token());
  } else {
    tasks_.Finish(held, *report);
    CallNow();
  }
  return !held.dropped;
}

void WorkerState::Add(const std::string& job, v1::FoldersSeen seen) {
  std::lock_guard<std::mutex> lock(mutex_);
  looks_.Add(job, std::move(seen));
  CallNow();
}

bool WorkerState::WaitFor(const HeldTask& held, absl::Duration pause) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto is_over = [&] { return held.cancel.cancelled() || ended_ || mode_ >= Mode::kStopping; };
  changed_.wait_for(lock, absl::ToChronoMilliseconds(pause), is_over);
  return !is_over();
}

}  // namespace tilemend
