#include "coordinator/plan/water/rim_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tilemend {
namespace {

// A number in [0, 1), the same on every machine.
double Random(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-32; }

// `count` heights: `on_level` of them at 0, the others on a bank of 0 to `bank` metres, all with noise of `noise`
// metres from peak to peak.
std::vector<double> Heights(int count, double on_level, double bank, double noise) {
  std::mt19937 random(7);
  std::vector<double> heights;
  for (int i = 0; i < count; ++i) {
    const double above = Random(random) < on_level ? 0 : bank * Random(random);
    heights.push_back(above + noise * (Random(random) - 0.5));
  }
  return heights;
}

double Deviation(double peak_to_peak) { return peak_to_peak / std::sqrt(12); }

TEST(FitRimLevelTest, NoiseAveragesOut) {
  for (const int count : {100, 300, 3000}) {
    const RimLevel fit = FitRimLevel(Heights(count, 1, 0, 0.05), Deviation(0.05));
    EXPECT_NEAR(fit.level, 0, 0.01) << count;
    EXPECT_NEAR(fit.spread, Deviation(0.05), 0.008) << count;
  }
}

TEST(FitRimLevelTest, VerticesOnTheBankDoNotLiftIt) {
  for (const double bank : {0.05, 0.25, 0.6, 3.0}) {
    EXPECT_NEAR(FitRimLevel(Heights(300, 0.5, bank, 0.05), Deviation(0.05)).level, 0, 0.015) << bank;
  }
}

TEST(FitRimLevelTest, AnOutlierDoesNotLowerIt) {
  std::vector<double> heights = Heights(300, 1, 0, 0.05);
  heights.push_back(-3);
  EXPECT_NEAR(FitRimLevel(heights, Deviation(0.05)).level, 0, 0.01);
}

TEST(FitRimLevelTest, WithoutNoiseNoVertexLiesBelow) {
  for (const double on_level : {0.0, 0.3, 1.0}) {
    const std::vector<double> heights = Heights(300, on_level, 0.25, 0);
    EXPECT_LE(FitRimLevel(heights, 0).level, *std::min_element(heights.begin(), heights.end()) + 1e-12) << on_level;
  }
}

TEST(FitRimLevelTest, TheOrderDoesNotMatter) {
  std::vector<double> heights = Heights(100, 0.5, 0.2, 0.05);
  const RimLevel fit = FitRimLevel(heights, 0.01);
  std::reverse(heights.begin(), heights.end());
  EXPECT_EQ(FitRimLevel(heights, 0.01).level, fit.level);
}

TEST(FitRimLevelTest, OneHeightIsTheLevel) {
  EXPECT_EQ(FitRimLevel({3.5}, 0.1).level, 3.5);
  EXPECT_EQ(FitRimLevel({3.5}, 0.1).spread, 0);
}

TEST(FitLowLevelTest, IsTheRimsWhereThatGathersAtTheWater) {
  const std::vector<double> heights = Heights(300, 0.5, 0.25, 0.05);
  EXPECT_EQ(FitLowLevel(heights, Deviation(0.05)).level, FitRimLevel(heights, Deviation(0.05)).level);
  EXPECT_EQ(FitLowLevel(heights, Deviation(0.05)).count, heights.size());
}

TEST(FitLowLevelTest, WaterShowsBetweenQuays) {
  std::vector<double> heights = Heights(12, 1, 0, 0.2);
  for (int i = 0; i < 30; ++i) heights.push_back(2.5 + 0.001 * i);
  const RimLevel fit = FitLowLevel(heights, Deviation(0.2));
  EXPECT_NEAR(fit.level, 0, 0.06);
  EXPECT_EQ(fit.count, 12u);
  EXPECT_GT(FitRimLevel(heights, Deviation(0.2)).level, 0.08);
}

TEST(FitLowLevelTest, MoreNoiseThanWasMeasuredIsNoQuay) {
  const std::vector<double> heights = Heights(60, 1, 0, 0.4);
  EXPECT_EQ(FitLowLevel(heights, 0.03).level, FitRimLevel(heights, 0.03).level);
  EXPECT_EQ(FitLowLevel(heights, 0.03).count, heights.size());
}

TEST(FitLowLevelTest, AFewLowHeightsAreNoWater) {
  std::vector<double> heights = Heights(3, 1, 0, 0.2);
  for (int i = 0; i < 30; ++i) heights.push_back(2.5 + 0.001 * i);
  EXPECT_EQ(FitLowLevel(heights, Deviation(0.2)).level, FitRimLevel(heights, Deviation(0.2)).level);
}

TEST(QuantileTest, LiesBetweenTheNeighbours) {
  EXPECT_EQ(Quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(Quantile({1, 2}, 0.25), 1.25);
  EXPECT_EQ(Quantile({4}, 0.9), 4);
  EXPECT_EQ(Quantile({1, 5}, 1), 5);
}

}  // namespace
}  // namespace tilemend
