#include "worker/service/worker_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/metrics/prometheus_registry.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST(WorkerMetricsTest, CountsByStage) {
  PrometheusRegistry registry;
  WorkerMetrics metrics(registry);
  for (const Stage stage : kAllStages) {
    WorkerMetrics::PerStage& counts = metrics.Of(stage);
    counts.started->Increment(6);
    counts.finished->Increment(1);
    counts.failed->Increment(2);
    counts.cancelled->Increment(3);
    counts.bytes_in->Increment(1000);
    counts.bytes_out->Increment(2000);
    counts.seconds->Observe(0.5);
  }
  const std::string text = registry.Text();
  for (const Stage stage : kAllStages) {
    const std::string label = "{stage=\"" + std::string(StageName(stage)) + "\"} ";
    for (const std::string& line :
         std::vector<std::string>{"tasks_started_total" + label + "6", "tasks_finished_total" + label + "1",
                                  "tasks_failed_total" + label + "2", "tasks_cancelled_total" + label + "3",
                                  "input_bytes_total" + label + "1000", "output_bytes_total" + label + "2000",
                                  "task_seconds_count" + label + "1", "task_seconds_sum" + label + "0.5"}) {
      EXPECT_THAT(text, HasSubstr("tilemend_worker_" + line + "\n"));
    }
  }
}

TEST(WorkerMetricsTest, CountsStagesOfAnotherReleaseTogether) {
  PrometheusRegistry registry;
  WorkerMetrics metrics(registry);
  metrics.Of(static_cast<Stage>(77)).started->Increment();
  metrics.Of(static_cast<Stage>(0)).started->Increment();
  EXPECT_THAT(registry.Text(), HasSubstr("tilemend_worker_tasks_started_total{stage=\"unknown\"} 2\n"));
}

TEST(WorkerMetricsTest, TellsWhetherItIsConnected) {
  PrometheusRegistry registry;
  WorkerMetrics metrics(registry);
  metrics.SetConnected(true);
  EXPECT_THAT(registry.Text(), HasSubstr("tilemend_worker_connected 1\n"));
  metrics.SetConnected(false);
  EXPECT_THAT(registry.Text(), HasSubstr("tilemend_worker_connected 0\n"));
}

}  // namespace
}  // namespace tilemend
