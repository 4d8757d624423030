// Tiles that overlap are planned as the clipped scene that they stand for; each is filled up to its own outline.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "common/mesh/triangulation/region_triangulation.h"
#include "coordinator/plan/hole/planar_regions.h"
#include "coordinator/plan/plan.h"
#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

using Picture = std::vector<std::string>;

// A lake over four cells, one that leaves the area, one in a cell, and a river over two cells.
const Picture kWaters = {
    "##########|######..##",  //
    "#..#######|######..##",  //
    "#..#######|##########",  //
    "##########|##########",  //
    "##########|##########",  //
    "##########|##########",  //
    "##########|##########",  //
    "#######...|..########",  //
    "#######...|..########",  //
    "#######...|..########",  //
    "----------+----------",  //
    "#######...|..########",  //
    "#######...|..########",  //
    "##########|##########",  //
    "##########|##########",  //
    "..........|..........",  //
    "..........|..........",  //
    "##########|##########",  //
    "##########|##########",  //
    "##########|##########",  //
    "##########|##########",  //
};

Plan PlanOf(const SurveyedScene& scene) { return MakePlan(scene.Input(), {}); }

// What the plan says, apart from how the seams were laid.
std::string Summary(const Plan& plan) {
  return CountsOf(plan) + "; clusters " + std::to_string(plan.clusters) + ", layers " + std::to_string(plan.layers);
}

std::vector<Point3> Positions(const Plan& plan) {
  std::vector<Point3> positions;
  for (const PlanVertex& v : plan.vertices) positions.push_back(v.position);
  return positions;
}

class OverlapTest : public ::testing::TestWithParam<double> {};

TEST_P(OverlapTest, CountsHolesAsOnTheClippedScene) {
  EXPECT_EQ(Summary(PlanOf(OverlappingScene(kWaters, 10, GetParam()))), Summary(PlanOf(PictureScene(kWaters, 10))));
}

TEST_P(OverlapTest, CountsAHoleOverSeveralPiecesOnce) {
  const Plan plan = PlanOf(OverlappingScene(kWaters, 10, GetParam(), 2));
  EXPECT_EQ(Summary(plan), Summary(PlanOf(PictureScene(kWaters, 10))));
  EXPECT_THAT(plan.left, IsEmpty());
}

TEST_P(OverlapTest, RegionsReachTheOutlineOfTheirOwnTile) {
  const double margin = GetParam();
  const Plan plan = PlanOf(OverlappingScene(kWaters, 10, margin));
  for (const PlannedHole& hole : plan.holes) {
    if (hole.kind == HoleKind::kClosed) continue;
    ASSERT_THAT(hole.own_regions, SizeIs(1));
    for (const RimSegment& s : hole.own_regions[0]) {
      if (!s.seam) continue;
      for (const int32_t v : {s.from, s.to}) {
        const Point3& p = plan.vertices[v].position;
        const double west = std::abs(p.x() - (hole.cell.col * 10 - margin));
        const double east = std::abs(p.x() - (hole.cell.col * 10 + 10 + margin));
        const double south = std::abs(p.y() - (hole.cell.row * 10 - margin));
        const double north = std::abs(p.y() - (hole.cell.row * 10 + 10 + margin));
        EXPECT_LT(std::min({west, east, south, north}), 1e-3) << p.transpose();
      }
    }
  }
}

TEST_P(OverlapTest, RegionsHaveTheAreaOfTheHoleAndTheOverlap) {
  const double margin = GetParam();
  const Plan plan = PlanOf(OverlappingScene(kWaters, 10, margin, 2));
  const std::vector<Point3> positions = Positions(plan);
  double area = 0;
  for (const PlannedHole& hole : plan.holes) {
    for (const auto& region : hole.own_regions) {
      const PlanarRegions planar = FindPlanarRegions(region, positions);
      EXPECT_THAT(planar.triangulation.conflicts, IsEmpty());
      for (const double a : planar.area) area += a;
    }
    if (hole.own_regions.empty()) area += hole.area;
  }
  // Every piece is its square stretched, and so is what is missing of it.
  const double stretch = (5 + 2 * margin) / 5;
  EXPECT_NEAR(area, (4 + 4 + 25 + 40) * stretch * stretch, 2e-2);
}

// Both neighbours' new vertices take the surface from the same places on the line between them.
TEST_P(OverlapTest, NeighboursFollowTheSameVertices) {
  const Plan plan = PlanOf(OverlappingScene(kWaters, 10, GetParam()));
  std::map<int32_t, int> followers;
  for (const PlanVertex& v : plan.vertices) {
    if (v.index < 0 && v.follows >= 0 && plan.vertices[v.follows].index < 0) ++followers[v.follows];
  }
  ASSERT_FALSE(followers.empty());
  for (const auto& [vertex, count] : followers) {
    const Point3& p = plan.vertices[vertex].position;
    const bool inside = p.x() > 0 && p.x() < 20 && p.y() > 0 && p.y() < 20;
    const bool corner = plan.vertices[vertex].lines == 3;
    EXPECT_EQ(count, !inside ? 1 : corner ? 4 : 2) << p.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Margins, OverlapTest, ::testing::Values(0.05, 0.1, 0.25));

// Along a border where only one tile has surface, that tile's own vertices bound the hole.
TEST(OverlapBorderTest, ACellWithoutATileIsOneHole) {
  const Picture picture = {"####|....|####", "####|....|####", "####|....|####", "####|....|####"};
  const Plan plan = PlanOf(OverlappingScene(picture, 4, 0.1));
  EXPECT_EQ(Summary(plan), Summary(PlanOf(PictureScene(picture, 4))));
}

// A gap all along a border is how the tiles are stored.
TEST(OverlapBorderTest, AGapBetweenTilesIsNoHole) {
  const Picture picture = {"####|####", "####|####", "####|####", "####|####"};
  EXPECT_THAT(PlanOf(OverlappingScene(picture, 4, -0.05)).holes, IsEmpty());
}

}  // namespace
}  // namespace tilemend
