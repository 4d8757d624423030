#include "coordinator/jobs/coordinator_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/metrics/prometheus_registry.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class CoordinatorMetricsTest : public ::testing::Test {
 protected:
  void ExpectLine(const std::string& line) {
    EXPECT_THAT(registry_.Text(), HasSubstr(absl::StrCat("tilemend_coordinator_", line, "\n")));
  }
  PrometheusRegistry registry_;
  CoordinatorMetrics metrics_{registry_};
};

TEST_F(CoordinatorMetricsTest, CountsTasksByStage) {
  for (const Stage stage : kAllStages) {
    metrics_.Started(stage);
    metrics_.Started(stage);
    metrics_.Retried(stage);
    metrics_.Refused(stage, true);
  }
  for (const Stage stage : kAllStages) {
    const std::string label = absl::StrCat("{stage=\"", std::string(StageName(stage)), "\"} ");
    ExpectLine(absl::StrCat("tasks_started_total", label, 2));
    ExpectLine(absl::StrCat("tasks_retried_total", label, 1));
    ExpectLine(absl::StrCat("tasks_refused_late_total", label, 1));
  }
}

TEST_F(CoordinatorMetricsTest, CountsStagesOfAnotherReleaseTogether) {
  metrics_.Started(static_cast<Stage>(99));
  metrics_.Started(static_cast<Stage>(0));
  ExpectLine("tasks_started_total{stage=\"unknown\"} 2");
}

TEST_F(CoordinatorMetricsTest, TellsHowTasksEndedAndWhatTheyTook) {
  SettledTask task;
  task.stage = Stage::kSampleCluster;
  task.leased_at = absl::FromUnixSeconds(100);
  for (const TaskState state : {TaskState::kCommitted, TaskState::kFailed, TaskState::kQuarantined}) {
    task.state = state;
    metrics_.Settled(task, absl::FromUnixSeconds(102));
  }
  ExpectLine("tasks_finished_total{stage=\"sample_cluster\"} 1");
  ExpectLine("tasks_failed_total{stage=\"sample_cluster\"} 1");
  ExpectLine("tasks_quarantined_total{stage=\"sample_cluster\"} 1");
  ExpectLine("task_seconds_sum{stage=\"sample_cluster\"} 6");
  ExpectLine("tasks_finished_total{stage=\"sample_layer\"} 0");
}

TEST_F(CoordinatorMetricsTest, CountsBytesOfBlobs) {
  metrics_.BlobSent(1000);
  metrics_.BlobReceived(30);
  metrics_.BlobReceived(4);
  ExpectLine("blob_sent_bytes_total 1000");
  ExpectLine("blob_received_bytes_total 34");
}

TEST_F(CoordinatorMetricsTest, ShowsJobsTasksAndWorkersOfTheState) {
  CoordinatorState state;
  const absl::Time now = absl::FromUnixSeconds(1);
  TaskLeased lease;
  lease.key.job = std::string("a");
  lease.key.task = 1;
  lease.worker = std::string("w");
  lease.token = 1;
  lease.time = lease.deadline = now;
  const TaskSpec one{{0, 0}, Stage::kFill, "x"}, two{{1, 0}, Stage::kFill, "y"};
  const std::vector<Event> events = {JobCreated{"a", "", now}, TasksAdded{"a", {one, two}},
                                     WorkerSeen{"w", 1, false, now}, lease};
  for (const Event& event : events) ASSERT_TRUE(state.Apply(event).ok());
  metrics_.Show(state);
  ExpectLine("jobs{state=\"running\"} 1");
  ExpectLine("jobs{state=\"done\"} 0");
  ExpectLine("tasks_pending 1");
  ExpectLine("tasks_running 1");
  ExpectLine("workers_connected 1");
}

}  // namespace
}  // namespace tilemend
