#include "coordinator/plan/water/water.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Plan PlanOf(const SceneMakerOptions& scene, const WaterOptions& water = {}) {
  PlanOptions options;
  options.water = water;
  return MakePlan(SurveyScene(MakeScene(scene)).Input(), options);
}

int64_t WatersOf(const Plan& plan) { return std::ranges::count(plan.water, BodyKind::kWater, &WaterBody::kind); }

std::vector<Point2> Box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

// The direction of (x, y) from the middle of the hole, as a share of the full circle.
double Bearing(double x, double y) { return std::atan2(y - 59, x - 61) / (2 * std::numbers::pi) + 0.5; }

class WaterTest : public ::testing::TestWithParam<Cut> {};

TEST_P(WaterTest, ALakeOverNineCellsHasOneLevel) {
  for (const double bank : {0.0, 0.03, 0.1, 0.4}) {
    const Plan plan = PlanOf(LakeOverNineCells(GetParam(), bank));
    ASSERT_THAT(plan.water, SizeIs(1)) << bank;
    const WaterBody& lake = plan.water[0];
    EXPECT_NEAR(lake.level, kWaterLevel, 0.04) << bank;
    EXPECT_EQ(std::fmod(lake.level, plan.lattice_step), 0);
    EXPECT_FALSE(lake.forced);
    EXPECT_GT(lake.rim_vertices, 100);
    EXPECT_LT(lake.sigma, 0.06);
    EXPECT_EQ(lake.kind, bank > 0 ? BodyKind::kWater : BodyKind::kLevelGround) << bank;
    std::set<CellId> cells;
    for (const int32_t h : lake.holes) cells.insert(plan.holes[h].cell);
    EXPECT_THAT(cells, SizeIs(9));
    for (const PlannedHole& hole : plan.holes) EXPECT_EQ(hole.water, 0);
  }
}

TEST_P(WaterTest, WithoutNoiseNoRimVertexIsBelowTheLevel) {
  SceneMakerOptions scene = LakeOverNineCells(GetParam());
  scene.noise = 0;
  const Plan plan = PlanOf(scene);
  ASSERT_THAT(plan.water, SizeIs(1));
  EXPECT_NEAR(plan.water[0].level, kWaterLevel, 0.002);
  EXPECT_LE(plan.water[0].level, plan.water[0].lowest);
}

TEST_P(WaterTest, SeamsTakeTheLevel) {
  const Plan plan = PlanOf(LakeOverNineCells(GetParam()));
  ASSERT_THAT(plan.water, SizeIs(1));
  SeamHeights heights;
  SettleWater(plan, heights);
  size_t seam_vertices = 0;
  for (const PlanVertex& v : plan.vertices) seam_vertices += v.index < 0;
  EXPECT_GT(seam_vertices, 0U);
  EXPECT_THAT(heights.height, SizeIs(seam_vertices));
  for (const auto& [vertex, height] : heights.height) EXPECT_EQ(height, plan.water[0].level);
}

TEST_P(WaterTest, ASlopingValleyIsNoWater) {
  for (const double slope : {0.002, 0.005, 0.02, 0.1}) {
    EXPECT_THAT(PlanOf(ValleyOverNineCells(GetParam(), slope)).water, IsEmpty()) << slope;
  }
}

// Where the surface swells by 8 cm along the shore, a fall of 12 cm may be chance.
TEST_P(WaterTest, SwellAlongTheShoreIsNoFall) {
  const auto swell = [](double d, double x, double y) {
    const double wave = 0.08 * std::sin(2 * std::numbers::pi * 5 * Bearing(x, y));
    return kWaterLevel + 0.0012 * (x - 61) + wave + 0.1 * std::fmax(d, 0);
  };
  EXPECT_THAT(PlanOf(HoleOverNineCells(GetParam(), swell)).water, SizeIs(1));
}

TEST_P(WaterTest, ALevelRimWhoseGroundFallsAwayIsNoWater) {
  const auto mesa = [](double d, double, double) { return kWaterLevel - 0.05 * std::fmax(d, 0); };
  EXPECT_EQ(WatersOf(PlanOf(HoleOverNineCells(GetParam(), mesa))), 0);
}

TEST_P(WaterTest, HillsAreNoWater) {
  for (const uint64_t seed : {1, 2, 3}) {
    for (const double noise : {0.0, 0.05}) {
      SceneMakerOptions scene;
      scene.cut = GetParam();
      scene.seed = seed;
      scene.noise = noise;
      scene.lakes = scene.islands = scene.river = true;
      scene.small_per_cell = 6;
      const Plan plan = PlanOf(scene);
      EXPECT_GT(plan.holes.size(), 30U);
      EXPECT_EQ(WatersOf(plan), 0) << seed << ", noise " << noise;
    }
  }
}

TEST_P(WaterTest, AnIslandBelongsToTheShore) {
  SceneMakerOptions scene = LakeOverNineCells(GetParam());
  const int64_t without = PlanOf(scene).water.at(0).rim_vertices;
  scene.ellipses.clear();
  // A ring of boxes around a square island, which is land at the level.
  scene.boxes = {{{10, 10}, {110, 50}}, {{10, 70}, {110, 110}}, {{10, 50}, {50, 70}}, {{70, 50}, {110, 70}}};
  scene.terrain = [](double, double) { return kWaterLevel; };
  const Plan plan = PlanOf(scene);
  ASSERT_THAT(plan.water, SizeIs(1));
  EXPECT_NEAR(plan.water[0].level, kWaterLevel, 0.02);
  EXPECT_GT(plan.water[0].rim_vertices, without);
}

TEST_P(WaterTest, AQuayAlongATenthOfTheShoreIsNoObstacle) {
  const auto ground = [](double d, double x, double y) {
    return kWaterLevel + 0.1 * std::fmax(d, 0) + (Bearing(x, y) < 0.1 ? 1.5 : 0);
  };
  const Plan plan = PlanOf(HoleOverNineCells(GetParam(), ground));
  ASSERT_THAT(plan.water, SizeIs(1));
  EXPECT_NEAR(plan.water[0].level, kWaterLevel, 0.04);
  EXPECT_GT(plan.water[0].highest, kWaterLevel + 1.4);
}

// Between quays for a fifth of its length, and beside one for half of it.
TEST_P(WaterTest, ACanalHasTheLevelOfItsStations) {
  SceneMakerOptions scene;
  scene.cut = GetParam();
  scene.cell_size = 50;
  scene.spacing = 1;
  scene.noise = 0.1;
  scene.boxes = {{{5, 54}, {195, 66}}};
  scene.terrain = [](double x, double y) {
    const bool left = y > 60 && x<100, both = x> 110 && x < 150;
    const double bank = 0.1 * std::fmax(0, std::abs(y - 60) - 6);
    return kWaterLevel + bank + (left || both ? 2.5 : 0);
  };
  const Plan plan = PlanOf(scene);
  ASSERT_THAT(plan.water, SizeIs(1));
  EXPECT_THAT(plan.water[0].river.stations, IsEmpty());
  EXPECT_NEAR(plan.water[0].level, kWaterLevel, 0.05);
  EXPECT_NEAR(plan.water[0].shore_level, plan.water[0].level, plan.lattice_step);
}

// On one side the surface ends on the bank, up to 0.1 m above the water.
TEST_P(WaterTest, ABankOnOneSideIsNoFall) {
  const auto ground = [](double d, double x, double y) {
    return kWaterLevel + 0.10 * std::fmax(0, std::cos(2 * std::numbers::pi * Bearing(x, y))) + 0.1 * std::fmax(d, 0);
  };
  SceneMakerOptions scene = HoleOverNineCells(GetParam(), ground);
  scene.noise = 0.4;
  const Plan plan = PlanOf(scene);
  ASSERT_THAT(plan.water, SizeIs(1));
  EXPECT_NEAR(plan.water[0].level, kWaterLevel, 0.1);
}

TEST_P(WaterTest, WhatStandsAMetreAboveTheWaterIsAWall) {
  const auto ground = [](double d, double x, double y) {
    return kWaterLevel + 0.1 * std::fmax(d, 0) + (Bearing(x, y) < 0.1 ? 1.5 : 0);
  };
  const Plan plan = PlanOf(HoleOverNineCells(GetParam(), ground));
  ASSERT_THAT(plan.water, SizeIs(1));
  int walls = 0;
  for (const PlannedHole& hole : plan.holes) {
    for (const RimSegment& segment : hole.segments) {
      const PlanVertex& v = plan.vertices[segment.from];
      EXPECT_EQ(v.on_object, v.index >= 0 && v.position.z() > plan.water[0].level + 1) << v.position.transpose();
      walls += v.on_object;
    }
  }
  EXPECT_GT(walls, 5);
}

TEST_P(WaterTest, NoiseOfTheSurfaceHidesNoLake) {
  SceneMakerOptions scene = LakeOverNineCells(GetParam());
  scene.noise = 0.6;
  const Plan plan = PlanOf(scene);
  ASSERT_THAT(plan.water, SizeIs(1));
  EXPECT_NEAR(plan.water[0].level, kWaterLevel, 0.1);
}

TEST_P(WaterTest, SmallLakesAreNotLookedFor) {
  WaterOptions water;
  EXPECT_THAT(PlanOf(LakeOverNineCells(GetParam()), water).water, SizeIs(1));
  water.profile = *WaterProfileNamed("usgs");
  EXPECT_THAT(PlanOf(LakeOverNineCells(GetParam()), water).water, IsEmpty());
  water.areas = {{true, {{Box(0, 0, 120, 120)}}}};
  EXPECT_THAT(PlanOf(LakeOverNineCells(GetParam()), water).water, SizeIs(1));
}

TEST_P(WaterTest, EachLakeHasItsOwnLevel) {
  SceneMakerOptions scene = LakeOverNineCells(GetParam());
  scene.ellipses = {{{30, 60}, {25, 30}}, {{90, 60}, {25, 30}}};
  scene.terrain = [](double x, double y) {
    const double west = Point2((x - 30) / 25, (y - 60) / 30).norm(), east = Point2((x - 90) / 25, (y - 60) / 30).norm();
    return x < 60 ? 5 + std::fmax(west - 1, 0) : 7 + std::fmax(east - 1, 0);
  };
  const Plan plan = PlanOf(scene);
  ASSERT_THAT(plan.water, SizeIs(2));
  std::vector<double> levels = {plan.water[0].level, plan.water[1].level};
  std::sort(levels.begin(), levels.end());
  EXPECT_NEAR(levels[0], 5, 0.02);
  EXPECT_NEAR(levels[1], 7, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Cuts, WaterTest, ::testing::Values(Cut::kClipped, Cut::kRagged),
                         [](const auto& cut) { return NameOf(cut.param); });

// Also where the vertex on the grid line beside it stands on a tree.
TEST(WaterOfOverlapsTest, NewVerticesOnATilesOwnOutlineTakeTheLevel) {
  const Plan plan = PlanOf(LakeOverNineCells(Cut::kOverlap));
  ASSERT_THAT(plan.water, SizeIs(1));
  SeamHeights heights;
  SettleWater(plan, heights);
  int followers = 0;
  for (const int32_t h : plan.water[0].holes) {
    for (const std::vector<RimSegment>& region : plan.holes[h].own_regions) {
      for (const RimSegment& s : region) {
        if (plan.vertices[s.from].index >= 0 || plan.vertices[s.from].height_known) continue;
        ++followers;
        ASSERT_TRUE(heights.height.contains(s.from));
        EXPECT_EQ(heights.height.at(s.from), plan.water[0].level);
      }
    }
  }
  EXPECT_GT(followers, 10);
}

// A wall of 40 x 12 squares of 1 m by 5 cm with a slit: its rim is level within 10 cm.
TEST(WaterOfMeshesTest, ASlitInAWallIsNoWater) {
  std::vector<std::string> picture(12, std::string(40, '#'));
  for (const int row : {5, 6}) picture[row].replace(4, 32, 32, '.');
  const TriMesh wall = Moved(PictureMesh(picture), [](const Point3& p) { return Point3(p.x(), 0, 0.05 * p.y()); });
  Grid grid;
  grid.cell_size = Point2(60, 60);
  SurveyedScene scene = SurveyScene(grid, {{CellId{0, 0}, wall}});
  PlanInput input = scene.Input();
  input.has_grid = input.area_known = false;
  PlanOptions options;
  options.water.areas = {{true, {{Box(-100, -100, 100, 100)}}}};
  const Plan plan = MakePlan(input, options);
  EXPECT_EQ(plan.holes.size(), 1U);
  EXPECT_THAT(plan.water, IsEmpty());
}

TEST(WaterOfMeshesTest, AFewRimVerticesTellTooLittle) {
  // A pond of 3 x 3 squares in a bowl.
  const auto bowl = [](double x, double y) { return std::fmax(std::fmax(std::abs(x - 6.5), std::abs(y - 6.5)), 1.5); };
  std::vector<std::string> picture(13, std::string(13, '#'));
  for (int row = 5; row < 8; ++row) picture[row].replace(5, 3, "...");
  const SurveyedScene scene = PictureScene(picture, 13, bowl);
  const Plan plan = MakePlan(scene.Input(), {});
  EXPECT_EQ(plan.holes.size(), 1U);
  EXPECT_THAT(plan.water, IsEmpty());
  PlanOptions forced;
  forced.water.areas = {{true, {{Box(0, 0, 13, 13)}}}};
  const Plan pond = MakePlan(scene.Input(), forced);
  ASSERT_THAT(pond.water, SizeIs(1));
  EXPECT_EQ(pond.water[0].level, 1.5);
}

// A canal of 50 x 20 m between banks, and 18 m off a street of 50 x 10 m as high, with ground as low on its other
// side. Part of their rims is a quay, or a house.
TEST(WaterWithGroundTest, AStreetBesideACanalIsNoPartOfIt) {
  const auto height = [](double x, double y) {
    if (x > 25 && x < 45 && (std::abs(y - 10) < 0.5 || std::abs(y - 58) < 0.5)) return 7.0;
    const bool is_canal = x > 8.5 && x < 61.5 && y > 9.5 && y < 30.5;
    const bool is_street = x > 3.5 && x < 71.5 && y > 47.5 && y < 75;
    return is_canal || is_street ? 5.0 : 7.0;
  };
  std::vector<std::string> picture(80, std::string(80, '#'));
  for (int y = 10; y < 58; ++y) {
    if (y < 30 || y >= 48) picture[79 - y].replace(10, 50, 50, '.');
  }
  const SurveyedScene scene = PictureScene(picture, 80, height);
  PlanOptions options;
  options.water.profile.least_lake = 200;
  PlanInput input = scene.Input();
  ASSERT_EQ(WatersOf(MakePlan(input, options)), 1);
  EXPECT_THAT(MakePlan(input, options).water[0].holes, SizeIs(2)) << "their levels agree";

  RimGround& rim = input.rim_ground[{0, 0}];
  rim.on_object.assign(scene.records.at({0, 0}).vertices.size(), false);
  rim.ground.assign(rim.on_object.size(), 5);
  rim.side = 3;
  for (int32_t row = 0; row < 26; ++row) {
    for (int32_t col = 0; col < 26; ++col) {
      const Point2 middle(3 * col + 1.5, 3 * row + 1.5);
      const bool has_surface = picture[static_cast<size_t>(79 - middle.y())][static_cast<size_t>(middle.x())] == '#';
      if (has_surface) rim.around.push_back({col, row, static_cast<float>(height(middle.x(), middle.y()))});
    }
  }
  const Plan plan = MakePlan(input, options);
  ASSERT_EQ(WatersOf(plan), 1) << plan.evidence[0].reason;
  const WaterBody& canal = *std::ranges::find(plan.water, BodyKind::kWater, &WaterBody::kind);
  EXPECT_EQ(canal.level, 5);
  ASSERT_THAT(canal.holes, SizeIs(1));
  EXPECT_EQ(plan.holes[canal.holes[0]].area, 1000);
}

// Every large hole has words on what it was taken for.
TEST(SlopeTest, AHoleOnASlopeIsNoWater) {
  std::vector<std::string> picture(20, std::string(20, '#'));
  for (size_t row = 4; row < 16; ++row) picture[row].replace(4, 12, std::string(12, '.'));
  const SurveyedScene scene = PictureScene(picture, 20, [](double x, double) { return 0.9 * x; });
  const Plan plan = MakePlan(scene.Input(), {});
  ASSERT_THAT(plan.holes, SizeIs(1));
  ASSERT_EQ(plan.holes[0].evidence, 0);
  EXPECT_EQ(plan.evidence[0].verdict, HoleEvidence::Verdict::kNoWater);
  EXPECT_EQ(plan.evidence[0].reason, "it lies on a slope of 42 degrees");
  EXPECT_FALSE(plan.evidence[0].has_level);
}

}  // namespace
}  // namespace tilemend
