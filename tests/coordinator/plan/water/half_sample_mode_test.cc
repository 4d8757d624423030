#include "coordinator/plan/water/half_sample_mode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tilemend {
namespace {

std::vector<WeightedHeight> Sorted(std::vector<WeightedHeight> heights) {
  std::ranges::sort(heights);
  return heights;
}

TEST(HalfSampleModeTest, IsWhereTheHeightsAreDensest) {
  std::vector<WeightedHeight> heights;
  for (int i = 0; i < 40; ++i) heights.push_back({5 + 0.001 * i, 1, 1});
  for (int i = 0; i < 50; ++i) heights.push_back({0.3 * i, 1, 1});
  EXPECT_NEAR(HalfSampleMode(Sorted(heights)), 5.02, 0.02);
}

TEST(HalfSampleModeTest, OfFewHeightsIsTheirMean) {
  EXPECT_DOUBLE_EQ(HalfSampleMode(Sorted({{2, 1, 1}, {3, 1, 2}})), (2 + 2 * 3) / 3.0);
  EXPECT_DOUBLE_EQ(HalfSampleMode(Sorted({{7, 1, 1}})), 7);
}

TEST(HalfSampleModeTest, OfEqualHeightsIsExact) {
  const std::vector<WeightedHeight> heights(10, {0.1, 0.3, 0.7});
  EXPECT_EQ(HalfSampleMode(heights), 0.1);
}

TEST(HalfSampleModeTest, HeightsWithoutWeightDoNotCount) {
  EXPECT_DOUBLE_EQ(HalfSampleMode(Sorted({{1, 1, 0}, {1.01, 1, 0}, {1.02, 1, 0}, {4, 1, 1}, {4.5, 1, 2}})), 4.5);
  EXPECT_DOUBLE_EQ(HalfSampleMode(Sorted({{1, 0, 0}, {2, 0, 0}})), 2);
}

TEST(WeightedQuantileTest, GoesByLength) {
  const std::vector<WeightedHeight> heights = Sorted({{1, 3, 9}, {2, 1, 9}, {3, 6, 9}});
  EXPECT_EQ(WeightedQuantile(heights, 0.3), 1);
  EXPECT_EQ(WeightedQuantile(heights, 0.39), 2);
  EXPECT_EQ(WeightedQuantile(heights, 0.5), 3);
  EXPECT_EQ(WeightedQuantile(heights, 1), 3);
}

// A quay along less than half of the rim is denser than the water's edge.
TEST(LowerModeTest, LeavesOutTheUpperHalf) {
  std::vector<WeightedHeight> heights(30, {8, 1, 1});
  for (int i = 0; i < 40; ++i) heights.push_back({5 + 0.01 * i, 1, 1});
  EXPECT_NEAR(LowerMode(Sorted(heights)), 5.2, 0.2);
}

}  // namespace
}  // namespace tilemend
