#include "common/metrics/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(NullMetricsTest, GiveTheSameHandleForEveryNameAndTakeEverything) {
  MetricsRegistry* registry = MetricsRegistry::Null();
  EXPECT_EQ(registry, MetricsRegistry::Null());
  EXPECT_EQ(registry->AddCounter("a_total", "", {{"stage", "fill"}}), Counter::Null());
  EXPECT_EQ(registry->AddGauge("b", "", {}), Gauge::Null());
  EXPECT_EQ(registry->AddHistogram("c", "", {}, {1, 2}), Histogram::Null());
  Counter::Null()->Increment();
  Counter::Null()->Increment(1e300);
  Gauge::Null()->Set(-1);
  Histogram::Null()->Observe(0);
  // No handle of another kind, and none that is not there.
  EXPECT_THAT((std::set<void*>{Counter::Null(), Gauge::Null(), Histogram::Null()}), ::testing::SizeIs(3));
  EXPECT_NE(Counter::Null(), nullptr);
}

TEST(HistogramTest, BoundsAreScaled) {
  EXPECT_THAT(Histogram::ScaledBounds(1, 10, 3), ElementsAre(1, 10, 100));
  EXPECT_THAT(Histogram::ScaledBounds(0.25, 2, 4), ElementsAre(0.25, 0.5, 1, 2));
  EXPECT_THAT(Histogram::ScaledBounds(1, 10, 0), IsEmpty());
}

}  // namespace
}  // namespace tilemend
