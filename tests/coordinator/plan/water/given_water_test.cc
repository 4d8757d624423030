#include "coordinator/plan/water/given_water.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/rims.h"

namespace tilemend {
namespace {

constexpr double kMinRiver = 6;

GivenPart PartOf(size_t number, const Point2& lo, const Point2& hi, const HeightAt& height) {
  MadeRim rim = BoxRim(lo, hi, height);
  return {number, (hi - lo).prod(), std::move(rim.outline), std::move(rim.chains)};
}

HeightAt At(double level) {
  return [level](double, double) { return level; };
}

double Falling(double x, double) { return 10 - 0.004 * x; }

TEST(WaterOfAreaTest, OneAreaIsOneLakeWhereRimsAgree) {
  const std::vector<GivenWater> water =
      WaterOfArea({},
                  {PartOf(3, {0, 0}, {10, 10}, At(10.02)), PartOf(4, {20, 0}, {90, 40}, At(10)),
                   PartOf(5, {0, 60}, {20, 80}, At(12))},
                  kMinRiver);
  ASSERT_EQ(water.size(), 2u);
  EXPECT_EQ(water[0].parts, (std::vector<size_t>{4, 3}));
  EXPECT_NEAR(water[0].body.level, 10, 0.02);
  EXPECT_TRUE(water[0].body.forced);
  EXPECT_EQ(water[1].parts, (std::vector<size_t>{5}));
  EXPECT_NEAR(water[1].body.level, 12, 0.02);
}

TEST(WaterOfAreaTest, TheAreaMayGiveTheLevel) {
  WaterArea area;
  area.level = 9.25;
  const std::vector<GivenWater> water = WaterOfArea(area, {PartOf(0, {0, 0}, {400, 24}, Falling)}, kMinRiver);
  ASSERT_EQ(water.size(), 1u);
  EXPECT_EQ(water[0].body.level, 9.25);
  EXPECT_TRUE(water[0].body.river.stations.empty());
}

TEST(WaterOfAreaTest, ALevelThatWasMeasuredHasItsOwnSigma) {
  WaterArea area;
  area.level = 9.25;
  area.level_sigma = 0.125;
  EXPECT_EQ(WaterOfArea(area, {PartOf(0, {0, 0}, {400, 24}, Falling)}, kMinRiver)[0].body.sigma, 0.125);
}

TEST(WaterOfAreaTest, WhatFallsFarIsARiver) {
  const std::vector<GivenWater> water = WaterOfArea({}, {PartOf(0, {0, 0}, {400, 24}, Falling)}, kMinRiver);
  ASSERT_EQ(water.size(), 1u);
  EXPECT_FALSE(water[0].body.river.stations.empty());
}

TEST(WaterOfAreaTest, ALakeIsLevelWhateverItsRimSays) {
  WaterArea area;
  area.kind = WaterKind::kLake;
  for (const bool has_line : {false, true}) {
    if (has_line) area.centreline = {{0, 12}, {400, 12}};
    const std::vector<GivenWater> water = WaterOfArea(area, {PartOf(0, {0, 0}, {400, 24}, Falling)}, kMinRiver);
    ASSERT_EQ(water.size(), 1u);
    EXPECT_TRUE(water[0].body.river.stations.empty());
  }
}

// Too short for a fall to be believed of a rim alone: it has fewer than eight stations.
TEST(WaterOfAreaTest, ARiverFallsWhereItsRimAloneWouldNotTell) {
  WaterArea area;
  MadeRim rim = BoxRim(
      {0, 0}, {110, 24}, [](double x, double) { return 10 - 0.0006 * x; }, 0.02);
  const std::vector<GivenPart> parts = {{0, 2640, rim.outline, rim.chains}};
  EXPECT_TRUE(WaterOfArea(area, parts, kMinRiver)[0].body.river.stations.empty());
  area.kind = WaterKind::kRiver;
  EXPECT_FALSE(WaterOfArea(area, parts, kMinRiver)[0].body.river.stations.empty());
}

TEST(WaterOfAreaTest, AGivenCentrelineMakesARiverOfAnyShape) {
  WaterArea area;
  area.centreline = {{60, 30}, {0, 30}};
  const std::vector<GivenWater> water = WaterOfArea(area, {PartOf(0, {0, 0}, {60, 60}, Falling)}, kMinRiver);
  ASSERT_EQ(water.size(), 1u);
  ASSERT_FALSE(water[0].body.river.stations.empty());
  EXPECT_LT(water[0].body.river.stations.front().x(), water[0].body.river.stations.back().x());
}

TEST(WaterOfAreaTest, ALakeBesideAGivenCentrelineKeepsItsLevel) {
  WaterArea area;
  area.centreline = {{0, 12}, {400, 12}};
  const std::vector<GivenWater> water =
      WaterOfArea(area,
                  {PartOf(0, {0, 0}, {400, 24}, Falling), PartOf(1, {100, 40}, {160, 100}, At(11)),
                   PartOf(2, {200, 30}, {300, 70}, Falling)},
                  kMinRiver);
  ASSERT_EQ(water.size(), 2u);
  EXPECT_EQ(water[0].parts, (std::vector<size_t>{0, 2}));
  EXPECT_EQ(water[1].parts, (std::vector<size_t>{1}));
  EXPECT_NEAR(water[1].body.level, 11, 0.02);
}

TEST(WaterOfAreaTest, APondWithAShortShoreBesideAGivenCentrelineKeepsItsLevelToo) {
  WaterArea area;
  area.centreline = {{0, 12}, {400, 12}};
  const std::vector<GivenWater> water =
      WaterOfArea(area, {PartOf(0, {0, 0}, {400, 24}, Falling), PartOf(1, {100, 40}, {104, 44}, At(18))}, kMinRiver);
  ASSERT_EQ(water.size(), 2u);
  EXPECT_NEAR(water[1].body.level, 18, 0.05);
}

TEST(WaterOfAreaTest, ARiverOfTheUsersIsOneHoweverNarrow) {
  WaterArea area;
  area.kind = WaterKind::kRiver;
  const std::vector<GivenWater> water = WaterOfArea(area, {PartOf(0, {0, 0}, {400, 5}, Falling)}, kMinRiver);
  ASSERT_EQ(water.size(), 1u);
  EXPECT_FALSE(water[0].body.river.stations.empty());
}

TEST(WaterOfAreaTest, ReachesUnderBridgesAreOneRiver) {
  const std::vector<GivenPart> parts = {PartOf(4, {0, 0}, {240, 24}, Falling), PartOf(2, {252, 0}, {500, 24}, Falling),
                                        PartOf(7, {100, 60}, {160, 100}, At(12))};
  const std::vector<GivenWater> water = WaterOfArea({}, parts, kMinRiver);
  ASSERT_EQ(water.size(), 2u);
  EXPECT_EQ(water[0].parts, (std::vector<size_t>{4, 2}));
  const auto& stations = water[0].body.river.stations;
  ASSERT_FALSE(stations.empty());
  EXPECT_GT(stations.front().z(), stations.back().z());
  EXPECT_EQ(water[1].parts, (std::vector<size_t>{7}));
}

}  // namespace
}  // namespace tilemend
