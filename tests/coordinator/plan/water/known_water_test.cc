#include "coordinator/plan/water/known_water.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr CellId kCell{2, 1};

// Adds a hole that is the square [x, x + side) x [0, side), with new vertices around.
void AddSquare(double x, CellId cell, int32_t water, Plan& plan, double side = 10) {
  PlannedHole& hole = plan.holes.emplace_back();
  hole.cell = cell;
  hole.cluster = 0;
  hole.water = water;
  const auto first = static_cast<int32_t>(plan.vertices.size());
  for (const Point2& p : {Point2(x, 0), Point2(x + side, 0), Point2(x + side, side), Point2(x, side)}) {
    plan.vertices.emplace_back().position = {p.x(), p.y(), 0};
  }
  for (int32_t k = 0; k < 4; ++k) hole.segments.push_back({first + k, first + (k + 1) % 4, true});
}

WaterBody Lake(double level) {
  WaterBody lake;
  lake.level = level;
  return lake;
}

// Stations every 10 m along y = 5, from x = 0 to 100; it falls by a metre from one to the next.
WaterBody River() {
  WaterBody river;
  for (int k = 0; k <= 10; ++k) river.river.stations.emplace_back(10 * k, 5, 20 - k);
  return river;
}

Plan PlanWithStep() {
  Plan plan;
  plan.lattice_step = 0x1p-10;
  return plan;
}

TEST(FindKnownWaterTest, LevelGroundSaysNothing) {
  Plan whole = PlanWithStep(), plan = PlanWithStep();
  whole.water = {Lake(3)};
  whole.water[0].kind = BodyKind::kLevelGround;
  AddSquare(0, kCell, 0, whole);
  AddSquare(0, kCell, -1, plan);
  EXPECT_THAT(FindKnownWater(whole, plan).body_of, ElementsAre(-1));
}

TEST(FindKnownWaterTest, AHoleIsAPartOfTheBodyThatCoversMostOfIt) {
  Plan whole = PlanWithStep(), plan = PlanWithStep();
  whole.water = {Lake(3), Lake(4)};
  AddSquare(0, kCell, 0, whole);
  AddSquare(10, kCell, 1, whole);
  AddSquare(20, kCell, -1, whole);
  for (const double x : {-6, 2, 7, 20}) AddSquare(x, kCell, -1, plan);
  const KnownWater known = FindKnownWater(whole, plan);
  EXPECT_THAT(known.bodies, SizeIs(2));
  EXPECT_THAT(known.body_of, ElementsAre(-1, 0, 1, -1));
}

TEST(FindKnownWaterTest, AHoleAboveWaterIsNoPartOfIt) {
  Plan whole = PlanWithStep(), plan = PlanWithStep();
  whole.water = {Lake(3)};
  AddSquare(0, kCell, 0, whole);
  AddSquare(4, kCell, -1, whole, 2);
  AddSquare(1, kCell, -1, plan, 8);
  AddSquare(4, kCell, -1, plan, 2);
  EXPECT_THAT(FindKnownWater(whole, plan).body_of, ElementsAre(0, -1));
}

TEST(FindKnownWaterTest, OnlyHolesOfTheSameCellCount) {
  Plan whole = PlanWithStep(), plan = PlanWithStep();
  whole.water = {Lake(3)};
  AddSquare(0, kCell, 0, whole);
  AddSquare(0, {1, 1}, -1, plan);
  EXPECT_THAT(FindKnownWater(whole, plan).body_of, ElementsAre(-1));
}

TEST(KnownWaterTest, HolesArePartsUntilTheyAreForgotten) {
  KnownWater known{{WaterBody(), WaterBody()}, {0, 1, -1}};
  EXPECT_TRUE(known.IsPart(0));
  EXPECT_TRUE(known.IsPart(1));
  EXPECT_FALSE(known.IsPart(2));
  known.Forget({1});
  EXPECT_FALSE(known.IsPart(1));
  EXPECT_FALSE(KnownWater().IsPart(0));
}

TEST(AddKnownWaterTest, WhatIsKnownStays) {
  KnownWater known{{Lake(3)}, {0, -1, -1}};
  AddKnownWater({{Lake(4), Lake(5)}, {1, 1, -1}}, known);
  EXPECT_THAT(known.bodies, SizeIs(3));
  EXPECT_THAT(known.body_of, ElementsAre(0, 2, -1));
}

TEST(PartsOfKnownTest, HolesOfOneBodyAreOneAndWhatIsWaterStaysAsItIs) {
  Plan plan = PlanWithStep();
  for (const double x : {0, 10, 20, 30}) AddSquare(x, kCell, -1, plan);
  const KnownWater known{{Lake(3), Lake(4)}, {1, 0, 1, 0}};
  const std::vector<WaterBody> parts = PartsOfKnown(known, {false, true, false, true}, plan);
  ASSERT_THAT(parts, SizeIs(1));
  EXPECT_EQ(parts[0].level, 4);
  EXPECT_THAT(parts[0].holes, ElementsAre(0, 2));
}

TEST(PartsOfKnownTest, ARiverKeepsTheStationsBesideThePart) {
  Plan plan = PlanWithStep();
  AddSquare(42, kCell, -1, plan);
  WaterBody river = River();
  river.removed_rises = {{{50, 5}, 0.2}, {{90, 5}, 0.1}};
  const std::vector<WaterBody> parts = PartsOfKnown({{river}, {0}}, {false}, plan);
  ASSERT_THAT(parts, SizeIs(1));
  const std::vector<Point3>& stations = parts[0].river.stations;
  ASSERT_THAT(stations, SizeIs(5));
  EXPECT_EQ(stations.front(), Point3(30, 5, 17));
  EXPECT_EQ(stations.back(), Point3(70, 5, 13));
  EXPECT_EQ(parts[0].level, 13);
  EXPECT_THAT(parts[0].removed_rises, SizeIs(1));
  for (const double x : {42.0, 47.0, 52.0}) {
    EXPECT_EQ(LevelAt(parts[0], {x, 8}, plan.lattice_step), LevelAt(river, {x, 8}, plan.lattice_step));
  }
}

TEST(HoldLevelAtEdgesTest, GivesTheLevelToNewVerticesOfWaterBesideGroundAlone) {
  Plan plan = PlanWithStep();
  plan.water = {Lake(3)};
  AddSquare(0, kCell, 0, plan);
  plan.vertices[2].index = 7;
  HoldLevelAtEdges(plan);
  for (const PlanVertex& v : plan.vertices) EXPECT_FALSE(v.height_given);
  AddSquare(10, kCell, -1, plan);
  HoldLevelAtEdges(plan);
  for (size_t v = 0; v < plan.vertices.size(); ++v) EXPECT_EQ(plan.vertices[v].height_given, v < 4 && v != 2) << v;
  EXPECT_EQ(plan.vertices[1].position.z(), 3);
  EXPECT_EQ(plan.vertices[2].position.z(), 0);
}

class WaterInAreaTest : public ::testing::TestWithParam<Cut> {};

TEST_P(WaterInAreaTest, AShortShoreHasTheLevelOfTheWholeLake) {
  const SurveyedScene scene = SurveyScene(MakeScene(LakeOverNineCells(GetParam())));
  const Plan whole = MakePlan(scene.Input(), {});
  ASSERT_THAT(whole.water, SizeIs(1));
  PlanInput input = scene.Input();
  // No shore, and some 20 m of it.
  for (const double west : {45, 3}) {
    input.area.rings = {{{west, 50}, {west + 30, 50}, {west + 30, 70}, {west, 70}}};
    const Plan plan = MakePlan(input, {});
    ASSERT_THAT(plan.water, SizeIs(1)) << west;
    EXPECT_EQ(plan.water[0].level, whole.water[0].level);
    for (const PlannedHole& hole : plan.holes) EXPECT_EQ(hole.water, 0);
  }
}

TEST_P(WaterInAreaTest, WhereNoWaterIsLookedForThereIsNone) {
  PlanInput input;
  const SurveyedScene scene = SurveyScene(MakeScene(LakeOverNineCells(GetParam())));
  input = scene.Input();
  input.area.rings = {{{3, 50}, {33, 50}, {33, 70}, {3, 70}}};
  PlanOptions options;
  options.water.find = false;
  EXPECT_THAT(MakePlan(input, options).water, IsEmpty());
  options.water.find = true;
  options.water.areas = {{.water = false, .polygon = {{{{0, 40}, {60, 40}, {60, 80}, {0, 80}}}}}};
  EXPECT_THAT(MakePlan(input, options).water, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Cuts, WaterInAreaTest, ::testing::Values(Cut::kClipped, Cut::kRagged, Cut::kOverlap),
                         [](const auto& test) { return NameOf(test.param); });

}  // namespace
}  // namespace tilemend
