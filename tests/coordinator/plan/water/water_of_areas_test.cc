// What areas of the user's say of water (water.h).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "coordinator/plan/water/water.h"
#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

Plan PlanOf(const SceneMakerOptions& scene, const WaterOptions& water) {
  PlanOptions options;
  options.water = water;
  return MakePlan(SurveyScene(MakeScene(scene)).Input(), options);
}

std::vector<Point2> Box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

// A lake in the west. Beyond a bridge at x = 72 m a canal goes on between high banks.
SceneMakerOptions LakeAndCanal(Cut cut) {
  SceneMakerOptions scene = LakeOverNineCells(cut);
  scene.ellipses = {{{38, 60}, {30, 45}}, {{96, 60}, {20, 38}}};
  scene.terrain = [](double x, double y) {
    const double west = Point2((x - 38) / 30, (y - 60) / 45).norm(), east = Point2((x - 96) / 20, (y - 60) / 38).norm();
    const double ashore = x < 72 ? 3 * std::fmax(west - 1, 0) : 2 * std::fmax(east - 1, 0);
    return kWaterLevel + ashore + (x < 72 ? 0 : 0.1 * std::fmax(std::abs(y - 60) - 8, 0));
  };
  return scene;
}

class WaterOfAreasTest : public ::testing::TestWithParam<Cut> {};

TEST_P(WaterOfAreasTest, AreasForceAndForbid) {
  const SceneMakerOptions valley = ValleyOverNineCells(GetParam(), 0.02);
  WaterOptions water;
  water.areas = {{true, {{Box(0, 0, 120, 120)}}}};
  const Plan forced = PlanOf(valley, water);
  ASSERT_THAT(forced.water, SizeIs(1));
  EXPECT_TRUE(forced.water[0].forced);
  EXPECT_LT(forced.water[0].level, kWaterLevel + 0.02 * 120);
  water.areas[0].water = false;
  EXPECT_THAT(PlanOf(LakeOverNineCells(GetParam()), water).water, IsEmpty());
  water.areas.push_back({true, {{Box(0, 0, 120, 120)}}});
  EXPECT_THAT(PlanOf(LakeOverNineCells(GetParam()), water).water, SizeIs(1)) << "the last area decides";
}

TEST_P(WaterOfAreasTest, AnAreaMayGiveTheLevel) {
  WaterOptions water;
  water.areas = {{true, {{Box(0, 0, 120, 120)}}, 11.5}};
  const Plan plan = PlanOf(LakeOverNineCells(GetParam()), water);
  ASSERT_THAT(plan.water, SizeIs(1));
  EXPECT_EQ(plan.water[0].level, 11.5);
  EXPECT_TRUE(plan.water[0].river.stations.empty());
}

TEST_P(WaterOfAreasTest, AnAreaThatSaysWhatWasFoundDecidesNothing) {
  WaterOptions water;
  water.areas = {{true, {{Box(0, 0, 120, 120)}}, kWaterLevel}};
  water.areas[0].level_sigma = 0.25;
  water.areas[0].is_as_found = true;
  const Plan plan = PlanOf(LakeOverNineCells(GetParam()), water);
  ASSERT_THAT(plan.water, SizeIs(1));
  EXPECT_FALSE(plan.water[0].forced);
  EXPECT_FALSE(plan.water[0].level_is_given);
  EXPECT_EQ(plan.water[0].sigma, 0.25);
  const HoleEvidence& evidence = plan.evidence[plan.holes[plan.water[0].holes[0]].evidence];
  EXPECT_EQ(evidence.area, -1);
  EXPECT_EQ(evidence.sigma, 0.25);
  EXPECT_GT(evidence.chance_wrong, 0);
  EXPECT_GT(evidence.dry_difference, 0);
}

TEST_P(WaterOfAreasTest, AnAreaMayGiveTheCentreline) {
  WaterOptions water;
  water.areas = {{true, {{Box(0, 0, 120, 120)}}, std::nullopt, {{110, 60}, {10, 60}}}};
  const Plan plan = PlanOf(ValleyOverNineCells(GetParam(), 0.01), water);
  ASSERT_THAT(plan.water, SizeIs(1));
  const std::vector<Point3>& stations = plan.water[0].river.stations;
  ASSERT_THAT(stations, Not(IsEmpty()));
  EXPECT_GT(stations.front().x(), stations.back().x());
  EXPECT_GT(stations.front().z(), stations.back().z() + 0.3);
}

TEST_P(WaterOfAreasTest, ALakeBesideAGivenCentrelineKeepsItsLevel) {
  SceneMakerOptions scene = LakeOverNineCells(GetParam());
  scene.ellipses = {{{61, 30}, {55, 14}}, {{61, 90}, {40, 22}}};
  scene.terrain = [](double x, double y) { return y < 55 ? kWaterLevel - 0.002 * x : kWaterLevel + 1; };
  WaterOptions water;
  water.areas = {{true, {{Box(0, 0, 120, 120)}}, std::nullopt, {{10, 30}, {110, 30}}}};
  const Plan plan = PlanOf(scene, water);
  ASSERT_THAT(plan.water, SizeIs(2));
  const bool lake_first = plan.water[0].river.stations.empty();
  const WaterBody &lake = plan.water[lake_first ? 0 : 1], &river = plan.water[lake_first ? 1 : 0];
  EXPECT_NEAR(lake.level, kWaterLevel + 1, 0.02);
  EXPECT_THAT(lake.river.stations, IsEmpty());
  EXPECT_NEAR(LevelAt(river, {61, 30}, plan.lattice_step), kWaterLevel - 0.12, 0.03);
  EXPECT_THAT(plan.water_answers[0].doubt, HasSubstr("does not run through"));
}

TEST_P(WaterOfAreasTest, AnAreaOverLessThanHalfDecidesNothing) {
  WaterOptions water;
  water.areas = {{false, {{Box(0, 0, 120, 50)}}}, {true, {{Box(500, 500, 600, 600)}}}, {true, {{Box(0, 0, 120, 100)}}}};
  const Plan plan = PlanOf(LakeOverNineCells(GetParam()), water);
  EXPECT_THAT(plan.water, SizeIs(1));
  ASSERT_THAT(plan.water_answers, SizeIs(3));
  for (const size_t a : {0, 1, 2}) EXPECT_EQ(plan.water_answers[a].taken, a == 2) << plan.water_answers[a].reason;
}

TEST_P(WaterOfAreasTest, OffFindsNothingButWhatAreasSay) {
  WaterOptions off;
  off.find = false;
  EXPECT_THAT(PlanOf(LakeOverNineCells(GetParam()), off).water, IsEmpty());
  off.areas = {{true, {{Box(0, 0, 120, 120)}}}};
  EXPECT_THAT(PlanOf(LakeOverNineCells(GetParam()), off).water, SizeIs(1));
}

// The canal's rim tells no level of its own.
TEST_P(WaterOfAreasTest, AreasWithoutALevelTakeThatOfTheWaterBeside) {
  const SceneMakerOptions scene = LakeAndCanal(GetParam());
  const WaterArea lake = {true, {{Box(0, 0, 72, 120)}}}, canal = {true, {{Box(72, 0, 120, 120)}}};
  for (const WaterKind kind : {WaterKind::kUnsaid, WaterKind::kLake}) {
    for (const std::vector<WaterArea>& areas : {std::vector{lake, canal}, {canal}}) {
      WaterOptions water;
      water.areas = areas;
      for (WaterArea& area : water.areas) area.kind = kind;
      const Plan plan = PlanOf(scene, water);
      ASSERT_THAT(plan.water, SizeIs(areas.size() == 2 ? 1 : 2)) << "what areas say and what is found are two";
      for (const WaterBody& body : plan.water) EXPECT_NEAR(body.level, kWaterLevel, 0.05);
      for (const PlannedHole& hole : plan.holes) EXPECT_GE(hole.water, 0);
    }
  }
}

// Beside the lake a small hole in its shore, 4 cm higher, and a pond that is 2 m higher.
TEST_P(WaterOfAreasTest, OnePolygonIsOneLakeWhereShoresAgree) {
  SceneMakerOptions scene = LakeOverNineCells(GetParam());
  scene.ellipses = {{{50, 60}, {35, 40}}, {{91, 60}, {3, 3}}, {{107, 107}, {6, 6}}};
  scene.terrain = [](double x, double y) {
    if (x > 95 && y > 95) return kWaterLevel + 2;
    return x > 86 ? kWaterLevel + 0.04 : kWaterLevel;
  };
  for (const std::optional<double> given : {std::optional<double>(), std::optional<double>(11.5)}) {
    WaterOptions water;
    water.areas = {{true, {{Box(0, 0, 120, 120)}}, given}};
    const Plan plan = PlanOf(scene, water);
    ASSERT_THAT(plan.water, SizeIs(2));
    const size_t pond = plan.water[0].holes.size() < plan.water[1].holes.size() ? 0 : 1;
    EXPECT_NEAR(plan.water[1 - pond].level, given.value_or(kWaterLevel), 0.03);
    EXPECT_NEAR(plan.water[pond].level, given.value_or(kWaterLevel + 2), 0.02);
    EXPECT_EQ(plan.water[0].holes.size() + plan.water[1].holes.size(), plan.holes.size());
    EXPECT_TRUE(std::ranges::is_sorted(plan.water[1 - pond].holes));
  }
}

// The rims of holes that a reviewer decides on go on telling of the water that they were part of.
TEST_P(WaterOfAreasTest, ADecisionOnOneHoleChangesNoOther) {
  const SceneMakerOptions scene = LakeAndCanal(GetParam());
  const auto level_west = [](const Plan& plan) {
    for (const WaterBody& body : plan.water) {
      const PlannedHole& hole = plan.holes[body.holes.front()];
      if (plan.vertices[hole.segments[0].from].position.x() < 72) return body.level;
    }
    return 0.0;
  };
  const double before = level_west(PlanOf(scene, {}));
  WaterOptions west_alone;
  west_alone.areas = {{false, {{Box(72, 0, 120, 120)}}}};
  ASSERT_GT(before, kWaterLevel) << "both lakes are one";
  ASSERT_NE(level_west(PlanOf(scene, west_alone)), before);
  for (const ReviewDecision decision : {ReviewDecision::kOpen, ReviewDecision::kGround, ReviewDecision::kWater}) {
    WaterOptions water;
    water.areas = {{decision == ReviewDecision::kWater, {{Box(72, 0, 120, 120)}}}};
    water.areas[0].decision = decision;
    EXPECT_EQ(level_west(PlanOf(scene, water)), before) << static_cast<int>(decision);
  }
}

INSTANTIATE_TEST_SUITE_P(Cuts, WaterOfAreasTest, ::testing::Values(Cut::kClipped, Cut::kRagged),
                         [](const auto& cut) { return NameOf(cut.param); });

}  // namespace
}  // namespace tilemend
