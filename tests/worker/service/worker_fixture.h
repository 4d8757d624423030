// A worker whose coordinator does what a test says.
#ifndef TILEMEND_TESTS_WORKER_SERVICE_WORKER_FIXTURE_H_
#define TILEMEND_TESTS_WORKER_SERVICE_WORKER_FIXTURE_H_

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common/metrics/prometheus_registry.h"
#include "tests/worker/service/fake_link.h"
#include "worker/service/worker.h"

namespace tilemend {

inline absl::StatusOr<std::string> Echo(Stage, const std::string& input, const CancelToken&) {
  return "out of " + input;
}

// Runs until it is cancelled.
inline absl::StatusOr<std::string> UntilCancelled(Stage, const std::string&, const CancelToken& cancel) {
  while (!cancel.cancelled()) std::this_thread::yield();
  return absl::CancelledError("cancelled");
}

inline v1::TaskRef Ref(uint64_t token) {
  v1::TaskRef ref;
  ref.set_job("job");
  ref.set_task(static_cast<int64_t>(token));
  ref.set_attempt_token(token);
  return ref;
}

inline v1::Task TaskOf(uint64_t token, const std::string& input) {
  v1::Task task;
  *task.mutable_ref() = Ref(token);
  task.set_stage(static_cast<v1::Stage>(Stage::kFill));
  task.mutable_input()->set_content(input);
  task.mutable_input()->set_size(static_cast<int64_t>(input.size()));
  return task;
}

inline v1::SyncResponse Start(const std::vector<v1::Task>& tasks) {
  v1::SyncResponse response;
  for (const v1::Task& task : tasks) *response.add_start() = task;
  return response;
}

inline v1::SyncResponse Keep(const v1::SyncRequest& request) {
  v1::SyncResponse response;
  *response.mutable_keep() = request.held();
  return response;
}

inline v1::SyncResponse Acknowledge(const v1::SyncRequest& request) {
  v1::SyncResponse response = Keep(request);
  for (const v1::FinishedTask& finished : request.finished()) *response.add_acknowledged() = finished.ref();
  return response;
}

// A call with results is never interrupted: the answer comes at once. So a worker must have told all before it is left.
inline v1::SyncResponse AcknowledgementOf(const v1::Task& task) {
  v1::SyncResponse response;
  *response.add_acknowledged() = task.ref();
  return response;
}

inline bool HasFinished(const v1::SyncRequest& request) { return request.finished_size() > 0; }
inline bool HoldsNothing(const v1::SyncRequest& request) { return request.held_size() == 0 && !HasFinished(request); }

class WorkerTest : public testing::Test {
 protected:
  std::unique_ptr<Worker> NewWorker(StageRunner runner, int threads = 1, int prefetch = 1) {
    WorkerOptions options;
    options.id = "w";
    options.threads = threads;
    options.prefetch = prefetch;
    options.first_backoff = backoff_;
    options.max_backoff = backoff_;
    options.patience = patience_;
    options.on_end = [this] { ends_.fetch_add(1); };
    return std::make_unique<Worker>(options, coordinator_.NewLink(), std::move(runner), metrics_);
  }

  // What the worker reports of one task.
  v1::FinishedTask Run(StageRunner runner, const v1::Task& task) {
    const auto worker = NewWorker(std::move(runner));
    coordinator_.Answer(Start({task}));
    const v1::SyncRequest request = coordinator_.Answer(AcknowledgementOf(task), HasFinished);
    worker->Abandon();
    return request.finished(0);
  }

  // A worker of one thread that has begun task 1, which ends when it is cancelled, and holds task 2.
  std::unique_ptr<Worker> WorkerOnTheFirstOfTwo() {
    auto worker = NewWorker([this](Stage stage, const std::string& input, const CancelToken& cancel) {
      begun_.set_value();
      return UntilCancelled(stage, input, cancel);
    });
    coordinator_.Answer(Start({TaskOf(1, ""), TaskOf(2, "")}));
    begun_.get_future().wait();
    return worker;
  }

  std::promise<void> begun_;  // by WorkerOnTheFirstOfTwo
  FakeCoordinator coordinator_;
  PrometheusRegistry metrics_;
  absl::Duration backoff_ = absl::Milliseconds(1);
  absl::Duration patience_ = absl::InfiniteDuration();
  std::atomic<int> ends_ = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_WORKER_SERVICE_WORKER_FIXTURE_H_
