#include "coordinator/plan/seam/seam_heights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

constexpr CellId kWestCell{0, 0};
constexpr CellId kEastCell{1, 0};
constexpr double kFine = 0x1p-20;

// One seam of an original vertex at height `first`, `count` seam vertices numbered from 1, and an original vertex at
// height `last`.
Plan OneSeam(int32_t count, double first, double last) {
  Plan plan;
  plan.lattice_step = kFine;
  Seam seam{kWestCell, kEastCell, {}};
  for (int32_t k = 0; k < count + 2; ++k) {
    PlanVertex v;
    v.position = Point3(10, k, k == 0 ? first : k == count + 1 ? last : 0);
    v.index = k == 0 || k == count + 1 ? k : -1;
    plan.vertices.push_back(v);
    seam.vertices.push_back(k);
  }
  plan.seams.push_back(seam);
  return plan;
}

std::vector<SeamSample> FromBothCells(const std::vector<double>& heights) {
  std::vector<SeamSample> samples;
  for (size_t i = 0; i < heights.size(); ++i) {
    samples.push_back({kWestCell, static_cast<int32_t>(i) + 1, heights[i] - 1});
    samples.push_back({kEastCell, static_cast<int32_t>(i) + 1, heights[i] + 1});
  }
  return samples;
}

std::map<int32_t, double> Settle(const Plan& plan, const std::vector<SeamSample>& samples, double gamma,
                                 SeamHeights heights = {}) {
  SettleLayer(plan, samples, gamma, heights);
  return heights.height;
}

TEST(SettleLayerTest, TakesTheMeanOfTheTwoCells) {
  const Plan plan = OneSeam(1, 0, 0);
  EXPECT_THAT(Settle(plan, {{kWestCell, 1, 3}, {kEastCell, 1, 6}}, 0), ElementsAre(Pair(1, 4.5)));
}

TEST(SettleLayerTest, DoesNotSmoothWithGammaZero) {
  const Plan plan = OneSeam(3, 100, 100);
  EXPECT_THAT(Settle(plan, FromBothCells({2, 4, 12}), 0), ElementsAre(Pair(1, 2), Pair(2, 4), Pair(3, 12)));
}

// Eq. 6 over two neighbours on either side, with the original ends 0 and 10:
//   vertex 1 (2): (0 - 2 + 4 - 2 + 12 - 2) / 3 = 10 / 3
//   vertex 2 (4): (0 + 2 + 12 + 10 - 4 * 4) / 4 = 2
//   vertex 3 (12): (2 + 4 + 10 - 3 * 12) / 3 = -20 / 3
TEST(SettleLayerTest, SmoothsByEquations5And6) {
  const Plan plan = OneSeam(3, 0, 10);
  const auto heights = Settle(plan, FromBothCells({2, 4, 12}), 0.5);
  EXPECT_NEAR(heights.at(1), 2 + 0.5 * 10 / 3, kFine);
  EXPECT_NEAR(heights.at(2), 4 + 0.5 * 2, kFine);
  EXPECT_NEAR(heights.at(3), 12 - 0.5 * 20 / 3, kFine);
}

TEST(SettleLayerTest, ReachesTwoNeighboursFarAndNotThree) {
  const Plan plan = OneSeam(4, 0, 1000);
  const auto heights = Settle(plan, FromBothCells({0, 0, 0, 0}), 0.5);
  EXPECT_EQ(heights.at(2), 0) << "three places from the end at 1000 m";
  EXPECT_EQ(heights.at(3), 0.5 * 1000 / 4) << "two places from it";
}

TEST(SettleLayerTest, KeepsHeightsThatOneCellAloneGave) {
  const Plan plan = OneSeam(2, 0, 100);
  EXPECT_THAT(Settle(plan, {{kWestCell, 1, 5}, {kWestCell, 2, 7}}, 0.5), ElementsAre(Pair(1, 5), Pair(2, 7)));
}

TEST(SettleLayerTest, KeepsHeightsThatTwoHolesOfOneCellGave) {
  const Plan plan = OneSeam(1, 0, 100);
  EXPECT_THAT(Settle(plan, {{kWestCell, 1, 5}, {kWestCell, 1, 7}}, 0.5), ElementsAre(Pair(1, 6)));
}

TEST(SettleLayerTest, SmoothsTowardsVerticesOfEarlierLayers) {
  const Plan plan = OneSeam(2, 0, 0);
  const auto heights = Settle(plan, {{kWestCell, 1, 4}, {kEastCell, 1, 4}}, 0.5, SeamHeights{.height = {{2, 16.0}}});
  EXPECT_NEAR(heights.at(1), 4 + 0.5 * ((0 - 4) + (16 - 4) + (0 - 4)) / 3, kFine);
}

TEST(SettleLayerTest, IgnoresSamplesOfVerticesThatAreSettled) {
  const Plan plan = OneSeam(1, 0, 0);
  EXPECT_THAT(Settle(plan, {{kWestCell, 1, 4}, {kEastCell, 1, 9}}, 0.5, SeamHeights{.height = {{1, 2.5}}}),
              ElementsAre(Pair(1, 2.5)));
}

TEST(SettleLayerTest, GivesTheSameBitsForAnyOrderOfSamples) {
  Plan plan = OneSeam(6, 0.1, 0.7);
  plan.lattice_step = 0x1p-60;  // rounding hides nothing
  std::vector<SeamSample> samples;
  for (int32_t v = 1; v <= 6; ++v) {
    for (int32_t c = 0; c < 8; ++c) samples.push_back({{c % 2, 0}, v, 1e6 / 3 + 0.1 * v * (c + 1)});
  }
  const auto expected = Settle(plan, samples, 0.5);
  std::reverse(samples.begin(), samples.end());
  EXPECT_EQ(Settle(plan, samples, 0.5), expected);
  std::rotate(samples.begin(), samples.begin() + 7, samples.end());
  EXPECT_EQ(Settle(plan, samples, 0.5), expected);
}

TEST(SettleLayerTest, RoundsToThePlansLattice) {
  Plan plan = OneSeam(2, 0, 0);
  plan.lattice_step = 0.25;
  EXPECT_THAT(Settle(plan, {{kWestCell, 1, 3.13}, {kWestCell, 2, -3.1}}, 0), ElementsAre(Pair(1, 3.25), Pair(2, -3.0)));
}

TEST(SettleLayerTest, KeepsHeightsThatThePlanGave) {
  Plan plan = OneSeam(2, 0, 0);
  plan.vertices[1].position.z() = 7.123456789;
  plan.vertices[1].height_given = true;
  EXPECT_THAT(Settle(plan, {{kWestCell, 1, 3}, {kWestCell, 2, 4}}, 0), ElementsAre(Pair(1, 7.123456789), Pair(2, 4)));
}

TEST(SettleClusterTest, KeepsHeightsThatThePlanGave) {
  Plan plan = OneSeam(2, 0, 0);
  plan.vertices[1].position.z() = 7.123456789;
  plan.vertices[1].height_given = true;
  SeamHeights heights;
  SettleCluster(plan, 0, std::vector<ClusterSample>{{1, 3, 0.5}, {2, 4, 0.25}}, heights);
  EXPECT_THAT(heights.height, ElementsAre(Pair(1, 7.123456789), Pair(2, 4)));
}

TEST(SettleClusterTest, KeepsTheSurfaceUnderAnObjectAndItsSlope) {
  Plan plan = OneSeam(1, 30, 0);
  plan.vertices[0].on_object = true;
  SeamHeights heights;
  const std::vector<ClusterSample> samples = {{0, 2.5, 0, {0.5, -1}}};
  SettleCluster(plan, 4, samples, heights);
  ASSERT_EQ(heights.ground.size(), 1U);
  EXPECT_EQ(heights.ground.at({4, 0}).height, 2.5);
  EXPECT_EQ(heights.ground.at({4, 0}).slope, Point2(0.5, -1));
  EXPECT_THAT(heights.height, IsEmpty());
}

TEST(SettleClusterTest, WithWallsTheSurfaceNeedNotMeetOriginals) {
  const Plan plan = OneSeam(1, 30, 4);
  const std::vector<ClusterSample> samples = {{0, 29.5, 0}, {1, 12, 0}, {2, 4, 0}};
  SeamHeights heights;
  SettleCluster(plan, 4, samples, heights);
  EXPECT_THAT(heights.ground, IsEmpty());
  heights = {};
  heights.walls[4] = {{0, 0}, 0.1};
  SettleCluster(plan, 4, samples, heights);
  ASSERT_EQ(heights.ground.size(), 2U);
  EXPECT_EQ(heights.ground.at({4, 0}).height, 29.5);
  EXPECT_THAT(heights.height, ElementsAre(Pair(1, 12)));
  EXPECT_THAT(heights.laplacian, IsEmpty());
}

TEST(SettleClusterTest, TheOrderOfClustersIsOfNoImportance) {
  Plan plan = OneSeam(2, 0, 0);
  plan.vertices[0].on_object = true;
  const std::vector<ClusterSample> samples[2] = {{{0, 1, 0.1, {1, 0}}, {1, 3, 0.5, {2, 0}}},
                                                 {{0, 2, 0.2, {3, 0}}, {1, 4, 0.6, {4, 0}}, {2, 6, 0.7, {5, 0}}}};
  for (const int first : {0, 1}) {
    SeamHeights heights;
    for (const int cluster : {first, 1 - first}) SettleCluster(plan, cluster, samples[cluster], heights);
    EXPECT_THAT(heights.height, ElementsAre(Pair(1, 3), Pair(2, 6)));
    EXPECT_EQ(heights.slope.at(1).slope, Point2(2, 0));
    EXPECT_EQ(heights.slope.at(2).slope, Point2(5, 0));
    EXPECT_EQ(heights.ground.at({0, 0}).slope, Point2(1, 0));
    EXPECT_EQ(heights.ground.at({1, 0}).slope, Point2(3, 0));
  }
}

TEST(SettleLayerTest, SettlesNothingWithoutSamples) { EXPECT_THAT(Settle(OneSeam(2, 0, 0), {}, 0.5), IsEmpty()); }

}  // namespace
}  // namespace tilemend
