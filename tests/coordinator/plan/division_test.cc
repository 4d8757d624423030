// How seams part holes, and what is tried where they cannot.
#include "coordinator/plan/division.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "coordinator/plan/plan.h"
#include "tests/support/plan_checks.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(DivideSceneTest, MeetsFourSeamsInOneVertexWhereAGridCornerLiesInAHole) {
  const Plan plan = PlanOf(Picture{"####|####",  //
                                   "####|####",  //
                                   "##..|..##",  //
                                   "##..|..##",  //
                                   "----+----",  //
                                   "##..|..##",  //
                                   "##..|..##",  //
                                   "####|####",  //
                                   "####|####"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "4 IB");
  ASSERT_THAT(plan.seams, SizeIs(4));
  std::map<int32_t, int> ends;
  for (const Seam& seam : plan.seams) {
    ++ends[seam.vertices.front()];
    ++ends[seam.vertices.back()];
  }
  const auto corner = std::find_if(ends.begin(), ends.end(), [](const auto& end) { return end.second == 4; });
  ASSERT_NE(corner, ends.end());
  EXPECT_EQ(plan.vertices[corner->first].position.head<2>(), Point2(4, 4));
  EXPECT_EQ(plan.vertices[corner->first].lines, 3);
  EXPECT_EQ(plan.vertices[corner->first].index, -1);
}

TEST(DivideSceneTest, PartsTheSeamWhereAnIslandLiesAcrossTheGridLine) {
  const Plan plan = PlanOf(Picture{"######|######",  //
                                   "#.....|.....#",  //
                                   "#.....|.....#",  //
                                   "#....#|#....#",  //
                                   "#.....|.....#",  //
                                   "######|######"},
                           6);
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "2 ID") << "in either cell the island is a part that touches one side";
  EXPECT_THAT(plan.seams, SizeIs(2));
}

TEST(DivideSceneTest, TakesASeamOverARimVertexCloseBesideTheGridLine) {
  SurveyedScene scene = PictureScene({"######|######",  //
                                      "#.##..|.....#",  //
                                      "#.##..|.....#",  //
                                      "#.....|.....#",  //
                                      "#.....|.....#",  //
                                      "######|######"},
                                     6);
  const Point3 tip(5.9, 3, 0);
  for (Point3& p : scene.tiles.at({0, 0}).points) {
    if (p == Point3(4, 3, 0)) p = tip;
  }
  const Plan plan = PlanOf(SurveyScene(scene.grid, std::move(scene.tiles)));
  ExpectSound(plan);
  ASSERT_THAT(plan.seams, SizeIs(1));
  const auto& way = plan.seams[0].vertices;
  EXPECT_EQ(std::count_if(way.begin(), way.end(), [&](int32_t v) { return plan.vertices[v].position == tip; }), 1);
}

// A scene of one cell with two gaps along its north side, and between them a square that ends `off` short of it.
SurveyedScene SquareShortOfTheNorth(double off) {
  SurveyedScene scene = PictureScene({"####..#..###", "############", "############", "############",  //
                                      "############", "############", "############", "############",  //
                                      "############", "############", "############", "############"},
                                     12, [](double x, double) { return 0.3 * x; });
  for (Point3& p : scene.tiles.at({0, 0}).points) {
    if ((p.x() == 6 || p.x() == 7) && p.y() == 12) p.y() -= off;
  }
  return SurveyScene(scene.grid, std::move(scene.tiles));
}

TEST(DivideSceneTest, PutsSeamVerticesBesideRimVerticesAHairOffTheRimOfTheArea) {
  const Plan plan = PlanOf(SquareShortOfTheNorth(1e-4));
  ExpectSound(plan);
  std::vector<Point3> given;
  for (const PlanVertex& v : plan.vertices) {
    if (v.height_given) given.push_back(v.position);
  }
  EXPECT_THAT(given, ElementsAre(Point3(6, 12, 0.3 * 6), Point3(7, 12, 0.3 * 7)));
}

TEST(DivideSceneTest, TakesASeamOverRimVerticesThatAreAsGoodAsOnTheRimOfTheArea) {
  const Plan plan = PlanOf(SquareShortOfTheNorth(1e-5));
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "2 IIB");
  for (const PlanVertex& v : plan.vertices) EXPECT_FALSE(v.height_given);
}

Division DivideSceneOf(const SurveyedScene& scene, Rim& rim, GridLines& lines) {
  const PlanInput input = scene.Input();
  const PlanOptions options;
  lines = FindGridLines(input, AuditBorders(input), 0x1p-10);
  rim = BuildRim(input);
  const Part part{input, input, lines, options, rim, 0x1p-10};
  const ClosingCells closing = FindClosingCells(input, lines, rim);
  return DivideScene(part, closing);
}

TEST(DivideSceneTest, PartsAHoleAtTheLineBetweenItsCells) {
  const SurveyedScene scene = PictureScene({"####|####", "##..|.###", "##..|.###", "####|####"}, 4);
  Rim rim;
  GridLines lines;
  const Division division = DivideSceneOf(scene, rim, lines);
  EXPECT_THAT(division.seams.seams, SizeIs(1));
  ASSERT_THAT(division.holes, SizeIs(2));
  EXPECT_EQ(division.holes.at({0, 0}).holes.at(0).area, 4);
  EXPECT_EQ(division.holes.at({1, 0}).holes.at(0).area, 2);
}

// Cells of a few edges: the first reading of the zigzag bounds no regions in some places, and another one is tried.
TEST(DivideSceneTest, BoundsMostHolesOfCoarseRaggedCuts) {
  size_t holes = 0, failed = 0;
  for (const uint64_t seed : {24, 31, 41}) {
    SceneMakerOptions options;
    options.cols = options.rows = 5;
    options.cut = Cut::kRagged;
    options.seed = seed;
    options.cell_size = seed == 24 ? 20 : 12;
    options.spacing = 2;
    options.lakes = options.islands = options.river = true;
    options.small_per_cell = 5;
    const Plan plan = PlanOf(SurveyScene(MakeScene(options)));
    holes += plan.holes.size();
    for (const PlannedHole& hole : plan.holes) failed += !hole.failure.empty();
  }
  EXPECT_GT(holes, 80U);
  EXPECT_LE(failed, holes / 10);
}

}  // namespace
}  // namespace tilemend
