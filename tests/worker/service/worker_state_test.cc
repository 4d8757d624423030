#include "worker/service/worker_state.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "common/metrics/prometheus_registry.h"
#include "tests/worker/service/worker_fixture.h"

namespace tilemend {
namespace {

using Mode = WorkerState::Mode;

class WorkerStateTest : public testing::Test {
 protected:
  WorkerStateTest() : metrics_(registry_), state_(1, 1, metrics_) {}

  std::shared_ptr<HeldTask> Began(uint64_t token) {
    EXPECT_TRUE(state_.Take({}, Start({TaskOf(token, "")})));
    return state_.NextWork()->task;
  }

  PrometheusRegistry registry_;
  WorkerMetrics metrics_;
  WorkerState state_;
  FakeCoordinator coordinator_;
};

TEST_F(WorkerStateTest, LooksAtFoldersBeforeItRunsTasks) {
  v1::SyncResponse response = Start({TaskOf(1, "")});
  response.add_look()->set_job("job");
  state_.Take({}, response);
  EXPECT_EQ(state_.NextWork()->folders->job(), "job");
  EXPECT_EQ(state_.NextWork()->task->task.ref().attempt_token(), 1u);
  state_.End();
  EXPECT_FALSE(state_.NextWork());
}

// Something happens while it runs.
struct EventfulCall : SyncCall {
  std::function<void()> event;
  bool interrupted = false;
  absl::StatusOr<v1::SyncResponse> Run(const v1::SyncRequest& /*request*/) override {
    event();
    return v1::SyncResponse();
  }
  void Interrupt() override { interrupted = true; }
};

TEST_F(WorkerStateTest, AResultInterruptsACallThatReportsNone) {
  const auto held = Began(1);
  const v1::FinishedTask report;
  v1::SyncRequest first, second;
  EventfulCall call;
  call.event = [&] { state_.Finish(*held, &report); };
  state_.Call(call, first);
  EXPECT_EQ(first.held_size(), 1);
  EXPECT_TRUE(call.interrupted);
  EventfulCall reports;
  reports.event = [&] { state_.SetMode(Mode::kDraining); };
  state_.Call(reports, second);
  EXPECT_EQ(second.finished_size(), 1);
  EXPECT_FALSE(reports.interrupted);
}

TEST_F(WorkerStateTest, DropsWhatTheCoordinatorDoesNotKeep) {
  const auto held = Began(1);
  v1::SyncRequest request;
  *request.add_held() = Ref(1);
  state_.Take(request, {});
  EXPECT_FALSE(state_.WaitFor(*held, absl::Hours(1)));
  v1::FinishedTask report;
  EXPECT_FALSE(state_.Finish(*held, &report));
}

TEST_F(WorkerStateTest, BeginsNothingOnceItStops) {
  const auto held = Began(1);
  state_.SetMode(Mode::kStopping);
  state_.SetMode(Mode::kDraining);
  EXPECT_FALSE(state_.is_running());
  EXPECT_TRUE(held->dropped);
  EXPECT_FALSE(state_.Take({}, Start({TaskOf(2, "")})));
  EXPECT_FALSE(state_.Pause(absl::Hours(1)));
}

TEST_F(WorkerStateTest, CallsNobodyOnceItIsAbandoned) {
  state_.SetMode(Mode::kAbandoned);
  const auto call = coordinator_.NewLink()->NewSync();
  v1::SyncRequest request;
  EXPECT_FALSE(state_.Call(*call, request));
}

TEST_F(WorkerStateTest, DrainingPausesOnlyWhileThereIsSomethingToTell) {
  const auto held = Began(1);
  state_.SetMode(Mode::kDraining);
  EXPECT_TRUE(state_.Pause(absl::Milliseconds(1)));
  state_.Finish(*held, nullptr);
  EXPECT_FALSE(state_.Pause(absl::Hours(1)));
}

}  // namespace
}  // namespace tilemend
