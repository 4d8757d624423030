#include "common/metrics/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/metrics/prometheus_registry.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(PrometheusRegistryTest, ShowsWhatWasCounted) {
  PrometheusRegistry registry;
  Counter* counter = registry.AddCounter("things_total", "Things.", {{"stage", "fill"}});
  counter->Increment();
  counter->Increment(2);
  registry.AddGauge("level", "Level.", {})->Set(7);
  registry.AddHistogram("seconds", "Time.", {}, {1, 10})->Observe(3);
  const std::string text = registry.Text();
  EXPECT_THAT(text, HasSubstr("things_total{stage=\"fill\"} 3\n"));
  EXPECT_THAT(text, HasSubstr("level 7\n"));
  EXPECT_THAT(text, HasSubstr("seconds_bucket{le=\"1\"} 0\n"));
  EXPECT_THAT(text, HasSubstr("seconds_bucket{le=\"10\"} 1\n"));
}

TEST(PrometheusRegistryTest, TheSameLabelsCountTogether) {
  PrometheusRegistry registry;
  registry.AddCounter("things_total", "Things.", {{"stage", "fill"}})->Increment();
  registry.AddCounter("things_total", "Things.", {{"stage", "fill"}})->Increment();
  EXPECT_THAT(registry.Text(), HasSubstr("things_total{stage=\"fill\"} 2\n"));
}

TEST(PrometheusRegistryTest, SaysWhenItsPortIsTaken) {
  PrometheusRegistry first;
  ASSERT_TRUE(first.Expose("127.0.0.1:0").ok());
  ASSERT_GT(first.port(), 0);
  PrometheusRegistry second;
  const absl::Status status = second.Expose("127.0.0.1:" + std::to_string(first.port()));
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
}

TEST(NullMetricsTest, TakeEverything) {
  MetricsRegistry* registry = MetricsRegistry::Null();
  registry->AddCounter("a", "", {})->Increment();
  registry->AddGauge("b", "", {})->Set(1);
  registry->AddHistogram("c", "", {}, {})->Observe(1);
}

TEST(HistogramTest, BoundsAreScaled) { EXPECT_THAT(Histogram::ScaledBounds(1, 10, 3), ElementsAre(1, 10, 100)); }

}  // namespace
}  // namespace tilemend
