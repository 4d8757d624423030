#include "common/mesh/quality_tally.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tilemend {
namespace {

TEST(QualityTallyTest, IsZeroWithoutTriangles) {
  const QualityTally tally;
  EXPECT_EQ(tally.triangles, 0);
  EXPECT_EQ(tally.Mean(), 0);
  EXPECT_EQ(tally.Quantile(0.05), 0);
}

TEST(QualityTallyTest, GivesMeanLeastAndQuantiles) {
  QualityTally tally;
  for (int k = 1; k <= 1000; ++k) tally.Add(k / 1000.0, false);
  EXPECT_NEAR(tally.Mean(), 0.5005, 1e-9);
  EXPECT_EQ(tally.least, 0.001);
  for (const double share : {0.05, 0.5, 0.95}) EXPECT_NEAR(tally.Quantile(share), share, 1.0 / QualityTally::kBins);
  EXPECT_NEAR(tally.Quantile(1), 1, 1e-12);
}

TEST(QualityTallyTest, CountsThePoorOnesAndThoseThatAreForced) {
  QualityTally tally;
  tally.Add(0.1, true);
  tally.Add(0.1, false);
  tally.Add(kPoorQuality, true);
  EXPECT_EQ(tally.poor, 2);
  EXPECT_EQ(tally.poor_forced, 1);
}

TEST(QualityTallyTest, MergesToTheSameInAnyOrderAndIsTheSameAfterPacking) {
  QualityTally all, even, odd;
  for (int k = 0; k < 1000; ++k) {
    const double quality = std::fmod(k * 0.618, 1);
    all.Add(quality, k % 3 == 0);
    (k % 2 == 0 ? even : odd).Add(quality, k % 3 == 0);
  }
  QualityTally other = odd;
  other.Merge(even);
  even.Merge(odd);
  for (const QualityTally& merged : {even, other, PackedTally(all).Unpack()}) {
    EXPECT_EQ(merged.triangles, all.triangles);
    EXPECT_EQ(merged.sum_millionths, all.sum_millionths);
    EXPECT_EQ(merged.least, all.least);
    EXPECT_EQ(merged.histogram, all.histogram);
    EXPECT_EQ(merged.poor, all.poor);
    EXPECT_EQ(merged.poor_forced, all.poor_forced);
  }
}

}  // namespace
}  // namespace tilemend
