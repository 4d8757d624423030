#include "common/metrics/prometheus_registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(PrometheusRegistryTest, ShowsWhatWasCounted) {
  PrometheusRegistry registry;
  Counter* counter = registry.AddCounter("things_total", "Things.", {{"stage", "fill"}});
  counter->Increment();
  counter->Increment(2);
  Gauge* gauge = registry.AddGauge("level", "Level.", {});
  gauge->Set(-3);
  gauge->Set(7);
  registry.AddHistogram("seconds", "Time.", {}, {1, 10})->Observe(3);
  const std::string text = registry.Text();
  EXPECT_THAT(text, HasSubstr("# HELP things_total Things.\n"));
  EXPECT_THAT(text, HasSubstr("# TYPE things_total counter\n"));
  EXPECT_THAT(text, HasSubstr("things_total{stage=\"fill\"} 3\n"));
  EXPECT_THAT(text, HasSubstr("level 7\n"));
  EXPECT_THAT(text, HasSubstr("seconds_bucket{le=\"1\"} 0\n"));
  EXPECT_THAT(text, HasSubstr("seconds_bucket{le=\"10\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("seconds_bucket{le=\"+Inf\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("seconds_sum 3\n"));
}

TEST(PrometheusRegistryTest, TheSameLabelsCountTogetherAndOthersApart) {
  PrometheusRegistry registry;
  for (const char* stage : {"fill", "fill", "plan"}) {
    registry.AddCounter("things_total", "Things.", {{"stage", stage}})->Increment();
    registry.AddGauge("level", "Level.", {{"stage", stage}})->Set(5);
    registry.AddHistogram("seconds", "Time.", {{"stage", stage}}, {1})->Observe(2);
  }
  const std::string text = registry.Text();
  EXPECT_THAT(text, HasSubstr("things_total{stage=\"fill\"} 2\n"));
  EXPECT_THAT(text, HasSubstr("things_total{stage=\"plan\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("seconds_count{stage=\"fill\"} 2\n"));
}

TEST(PrometheusRegistryTest, CountsFromManyThreads) {
  PrometheusRegistry registry;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&registry] {
      Counter* counter = registry.AddCounter("things_total", "Things.", {});
      for (int i = 0; i < 1000; ++i) counter->Increment();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(registry.Text(), HasSubstr("things_total 4000\n"));
}

}  // namespace
}  // namespace tilemend
