#include "worker/service/held_tasks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/metrics/prometheus_registry.h"
#include "common/rpc/limits.h"
#include "tests/worker/service/worker_fixture.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class HeldTasksTest : public testing::Test {
 protected:
  HeldTasksTest() : metrics_(registry_), tasks_(2, 2, metrics_) {}

  v1::SyncRequest Told() const {
    v1::SyncRequest request;
    tasks_.AddTo(request);
    return request;
  }
  static v1::FinishedTask ReportOn(uint64_t token, const std::string& content) {
    v1::FinishedTask report;
    *report.mutable_ref() = Ref(token);
    report.mutable_output()->set_content(content);
    return report;
  }

  PrometheusRegistry registry_;
  WorkerMetrics metrics_;
  HeldTasks tasks_;
};

TEST_F(HeldTasksTest, GivesATaskOnceInTheOrderInWhichTheyCame) {
  tasks_.Add(TaskOf(2, ""));
  tasks_.Add(TaskOf(1, ""));
  tasks_.Add(TaskOf(2, ""));
  EXPECT_EQ(tasks_.TakeNext()->task.ref().attempt_token(), 2u);
  EXPECT_EQ(tasks_.TakeNext()->task.ref().attempt_token(), 1u);
  EXPECT_FALSE(tasks_.has_next());
  EXPECT_EQ(tasks_.TakeNext(), nullptr);
}

TEST_F(HeldTasksTest, IsBusyWithAllThreadsAndHalfOfThePrefetch) {
  for (uint64_t token = 1; token <= 3; ++token) tasks_.Add(TaskOf(token, ""));
  EXPECT_FALSE(tasks_.is_busy());
  tasks_.Add(TaskOf(4, ""));
  EXPECT_TRUE(tasks_.is_busy());
}

TEST_F(HeldTasksTest, KeepsAResultUntilItIsAcknowledged) {
  tasks_.Add(TaskOf(1, ""));
  tasks_.Finish(*tasks_.TakeNext(), ReportOn(1, "done"));
  EXPECT_EQ(Told().finished_size(), 1);
  EXPECT_EQ(tasks_.finished_bytes(), 4u);
  tasks_.Add(TaskOf(1, ""));
  EXPECT_FALSE(tasks_.has_next()) << "it is done";
  tasks_.Acknowledge(1);
  EXPECT_TRUE(tasks_.is_empty());
  EXPECT_THAT(registry_.Text(), HasSubstr("tilemend_worker_tasks_finished_total{stage=\"fill\"} 1\n"));
}

TEST_F(HeldTasksTest, ADroppedTaskTakesAThreadUntilItEnds) {
  tasks_.Add(TaskOf(1, ""));
  tasks_.Add(TaskOf(2, ""));
  const auto running = tasks_.TakeNext();
  tasks_.Drop(1);
  tasks_.Drop(2);
  EXPECT_TRUE(running->cancel.cancelled());
  EXPECT_FALSE(tasks_.has_next());
  EXPECT_EQ(Told().held_size(), 0);
  EXPECT_EQ(Told().threads(), 1);
  tasks_.Finish(*running, ReportOn(1, "late"));
  EXPECT_TRUE(tasks_.is_empty());
  EXPECT_EQ(Told().threads(), 2);
  EXPECT_THAT(registry_.Text(), HasSubstr("tilemend_worker_tasks_cancelled_total{stage=\"fill\"} 1\n"));
}

TEST_F(HeldTasksTest, DropsAllTasksButNoResult) {
  for (uint64_t token = 1; token <= 3; ++token) tasks_.Add(TaskOf(token, ""));
  tasks_.Finish(*tasks_.TakeNext(), ReportOn(1, "done"));
  const auto running = tasks_.TakeNext();
  tasks_.DropTasks();
  EXPECT_TRUE(running->dropped);
  EXPECT_FALSE(tasks_.has_next());
  EXPECT_EQ(Told().finished_size(), 1);
  EXPECT_EQ(Told().held_size(), 0);
}

TEST_F(HeldTasksTest, ACancelledTaskStaysHeld) {
  tasks_.Add(TaskOf(1, ""));
  const auto running = tasks_.TakeNext();
  tasks_.CancelAll();
  EXPECT_TRUE(running->cancel.cancelled());
  EXPECT_EQ(Told().held_size(), 1);
}

TEST_F(HeldTasksTest, NamesAsHeldWhatDoesNotFitInACall) {
  for (uint64_t token = 1; token <= 2; ++token) {
    tasks_.Add(TaskOf(token, ""));
    tasks_.Finish(*tasks_.TakeNext(), ReportOn(token, std::string(kMaxInlineBytesPerSync / 2 + 1, 'x')));
  }
  EXPECT_EQ(Told().finished_size(), 1);
  EXPECT_EQ(Told().held_size(), 1);
}

}  // namespace
}  // namespace tilemend
