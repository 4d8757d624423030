#include "worker/service/worker.h"

#include <algorithm>
#include <utility>

namespace tilemend {

Worker::Worker(const WorkerOptions& options, std::unique_ptr<WorkLink> link, StageRunner runner,
               MetricsRegistry& metrics)
    : options_(options),
      link_(std::move(link)),
      metrics_(metrics),
      contact_(*options_.log, metrics_),
      state_(options_.threads, options_.prefetch, metrics_),
      loop_(options_, *link_, state_, contact_),
      blobs_(options_, *link_, state_, contact_),
      runner_(options_, std::move(runner), blobs_, state_, metrics_) {
  threads_.emplace_back([this] { CallUntilTheEnd(); });
  const int reading_or_writing = std::min(1 + options_.threads / 4, options_.prefetch);
  for (int i = 0; i < options_.threads + reading_or_writing; ++i) threads_.emplace_back([this] { runner_.RunAll(); });
}

Worker::~Worker() {
  Stop();
  Join().IgnoreError();
}

void Worker::Drain() { state_.SetMode(WorkerState::Mode::kDraining); }
void Worker::Stop() { state_.SetMode(WorkerState::Mode::kStopping); }
void Worker::Abandon() { state_.SetMode(WorkerState::Mode::kAbandoned); }

std::string Worker::WhyNotReady() { return state_.is_running() ? contact_.WhyNotReady() : "is ending"; }

absl::Status Worker::Join() {
  std::lock_guard<std::mutex> join_lock(join_mutex_);
  for (std::thread& thread : threads_) {
    if (thread.joinable()) thread.join();
  }
  return end_;
}

void Worker::CallUntilTheEnd() {
  end_ = loop_.Run();
  metrics_.SetConnected(false);
  state_.End();
  if (options_.on_end) options_.on_end();
}

}  // namespace tilemend
