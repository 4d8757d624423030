#include "coordinator/plan/water/basins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/rims.h"

namespace tilemend {
namespace {

constexpr double kMinRiver = 6;

Basin BasinOf(size_t number, const Point2& lo, const Point2& hi, const HeightAt& height) {
  MadeRim rim = BoxRim(lo, hi, height);
  const double area = (hi - lo).prod();
  return MakeBasin(number, std::move(rim.outline), std::move(rim.chains), area, kMinRiver);
}

double Level(double, double) { return 10; }

std::vector<Basin> Join(const Basin& a, const Basin& b) { return JoinBasins({a, b}, kMinRiver); }

TEST(JoinBasinsTest, BothSidesOfABridgeAreOneLake) {
  const std::vector<Basin> joined = Join(BasinOf(0, {0, 0}, {80, 40}, Level), BasinOf(1, {90, 0}, {150, 40}, Level));
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].members, (std::vector<size_t>{0, 1}));
  EXPECT_DOUBLE_EQ(joined[0].area, 80 * 40 + 60 * 40);
  EXPECT_NEAR(joined[0].evidence.level, 10, 0.02);
}

TEST(JoinBasinsTest, WaterOfAnotherLevelOrFarAwayIsAnother) {
  const Basin lake = BasinOf(0, {0, 0}, {80, 40}, Level);
  EXPECT_EQ(Join(lake, BasinOf(1, {90, 0}, {150, 40}, [](double, double) { return 11; })).size(), 2u);
  EXPECT_EQ(Join(lake, BasinOf(1, {290, 0}, {350, 40}, Level)).size(), 2u);
}

// Rising ground along most of the second, whose foot is at the water.
TEST(JoinBasinsTest, ARimOnTheBankTakesTheLevelOfItsNeighbour) {
  const auto bank = [](double x, double) { return 10 + 0.1 * std::max(0.0, std::abs(x - 120) - 5); };
  const Basin lake = BasinOf(0, {0, 0}, {80, 40}, Level), beyond = BasinOf(1, {90, 0}, {150, 30}, bank);
  ASSERT_FALSE(beyond.is_level());
  const std::vector<Basin> joined = Join(lake, beyond);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_NEAR(joined[0].evidence.level, 10, 0.03);
}

TEST(JoinBasinsTest, HillsideBesideALakeIsNoWater) {
  const auto hill = [](double x, double y) { return 20 + 0.2 * (x - 90) + 0.1 * y; };
  const std::vector<Basin> apart = Join(BasinOf(0, {0, 0}, {80, 40}, Level), BasinOf(1, {90, 0}, {150, 40}, hill));
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_TRUE(apart[0].is_level());
  EXPECT_FALSE(apart[1].is_level());
}

TEST(JoinBasinsTest, ReachesOfARiverAreOne) {
  const auto falling = [](double x, double) { return 10 - 0.004 * x; };
  const std::vector<Basin> joined =
      Join(BasinOf(0, {0, 0}, {240, 24}, falling), BasinOf(1, {252, 0}, {500, 24}, falling));
  ASSERT_EQ(joined.size(), 1u);
  ASSERT_TRUE(joined[0].river);
  for (const Point3& s : joined[0].river->water.stations) EXPECT_NEAR(s.z(), 10 - 0.004 * s.x(), 0.05);
}

TEST(JoinBasinsTest, TheOrderDoesNotMatter) {
  const Basin a = BasinOf(0, {0, 0}, {80, 40}, Level), b = BasinOf(1, {90, 0}, {150, 40}, Level);
  EXPECT_EQ(Join(a, b)[0].evidence.level, Join(b, a)[0].evidence.level);
}

// On an even slope a rim's foot is always nearer to the lake's level than to its own middle, however high it lies.
TEST(JoinBasinsTest, AHoleOnASlopeAboveALakeIsNoWater) {
  const auto slope = [](double x, double) { return 10 + 0.3 * (x - 80); };
  const std::vector<Basin> apart = Join(BasinOf(0, {0, 0}, {80, 40}, Level), BasinOf(1, {88, 0}, {128, 40}, slope));
  EXPECT_EQ(apart.size(), 2u);
}

TEST(BasinTest, WaterAtTheEdgeOfTheAreaIsAsWideAsItIs) {
  MadeRim rim = BoxRim({0, 0}, {400, 100}, Level);
  // Three sides are the edge of the area: they are in the outline, and no surface lies there.
  std::vector<RimChain> shore(1);
  for (const ChainEdge& edge : rim.chains[0]) {
    if (edge.middle.y() < 1) shore[0].push_back(edge);
  }
  const Basin basin = MakeBasin(0, rim.outline, shore, 400 * 100, kMinRiver);
  EXPECT_NEAR(basin.Width(), 2 * 400 * 100 / 1000.0, 0.01);
  Basin of_two = basin;
  of_two.outlines.push_back({{{0, 50}, {400, 50}}, {{400, 50}, {0, 50}}});  // a seam inside
  EXPECT_NEAR(of_two.Width(), basin.Width(), 0.01);
}

}  // namespace
}  // namespace tilemend
