#include "coordinator/state/patience.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

const absl::Time kStart = absl::FromUnixSeconds(1000);

TEST(PatienceTest, LosesNobodyForALeaseAfterAGap) {
  Patience patience(absl::Seconds(1), absl::Seconds(20));
  EXPECT_FALSE(patience.IsOver(kStart)) << "before the first look is a gap";
  absl::Time now = kStart;
  for (int i = 0; i < 20; ++i) patience.IsOver(now += absl::Seconds(1));
  EXPECT_TRUE(patience.IsOver(now += absl::Seconds(5)));
  EXPECT_FALSE(patience.IsOver(now += absl::Seconds(60))) << "it was stopped for a minute";
  for (int i = 0; i < 19; ++i) EXPECT_FALSE(patience.IsOver(now += absl::Seconds(1))) << i;
  EXPECT_TRUE(patience.IsOver(now += absl::Seconds(1)));
}

}  // namespace
}  // namespace tilemend
