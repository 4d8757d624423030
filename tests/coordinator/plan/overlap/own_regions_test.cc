#include "coordinator/plan/overlap/own_regions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/mesh/lattice.h"
#include "common/mesh/winding/wound_region.h"
#include "coordinator/plan/plan.h"
#include "tests/support/buffered_scene.h"
#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::SizeIs;

Plan PlanOf(const SurveyedScene& scene) { return MakePlan(scene.Input(), {}); }

std::vector<Point3> Positions(const Plan& plan) {
  std::vector<Point3> positions;
  for (const PlanVertex& v : plan.vertices) positions.push_back(v.position);
  return positions;
}

class OwnRegionsTest : public ::testing::TestWithParam<double> {};

TEST_P(OwnRegionsTest, ReachTheOutlineOfTheirOwnTile) {
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

// In square metres: what the segments wind around. Where chains of pieces are linked they run to and fro.
double AreaOf(const std::vector<RimSegment>& segments, const std::vector<Point3>& positions) {
  const LatticeWindow window({-1, -1}, {21, 21});
  std::vector<LatticePoint> points;
  for (const Point3& p : positions) points.push_back(window.Round(p.head<2>()));
  std::vector<DirectedEdge> edges;
  for (const RimSegment& s : segments) edges.push_back({s.from, s.to});
  const WoundRegion region = FindWoundRegion(points, edges);
  for (const RegionCorner& c : region.corners) points.push_back(c.place);
  double area = 0;
  for (const DirectedEdge& s : region.segments) {
    const Point2 a = window.ToMetres(points[s.from]), b = window.ToMetres(points[s.to]);
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return area;
}

TEST_P(OwnRegionsTest, HaveTheAreaOfTheHoleUpToTheOutline) {
  const double margin = GetParam();
  const Plan plan = PlanOf(OverlappingScene(kWaters, 10, margin));
  const std::vector<Point3> positions = Positions(plan);
  double area = 0;
  for (const PlannedHole& hole : plan.holes) {
    for (const auto& region : hole.own_regions) area += AreaOf(region, positions);
    if (hole.own_regions.empty()) area += hole.area;
  }
  const double stretch = (10 + 2 * margin) / 10;  // every tile is its square stretched, and so is what is missing of it
  EXPECT_NEAR(area, (4 + 4 + 25 + 40) * stretch * stretch, 2e-2);
}

TEST_P(OwnRegionsTest, AHoleOverPiecesHasOneRegion) {
  const double margin = GetParam();
  const Plan plan = PlanOf(OverlappingScene(kWaters, 10, margin, 2));
  const std::vector<Point3> positions = Positions(plan);
  double area = 0;
  for (const PlannedHole& hole : plan.holes) {
    EXPECT_LE(hole.own_regions.size(), 1U);
    for (const auto& region : hole.own_regions) area += AreaOf(region, positions);
    if (hole.own_regions.empty()) area += hole.area;
  }
  // Pieces reach into holes of their neighbours by the margin.
  EXPECT_NEAR(area, 4 + 4 + 25 + 40, 40 * margin);
}

// A pond that ends at the outline of the western pieces: the eastern ones have no rim there.
TEST(OverlappingPlanTest, TheWayAlongAPieceHasVerticesLikeTheRim) {
  const Plan plan = PlanOf(OverlappingScene({"##########", "##########", "##########", "##########", "##########",  //
                                             "#####....#", "#####....#", "#####....#", "#####....#", "##########"},
                                            10, 0.1, 2));
  const PlannedHole* pond = nullptr;
  for (const PlannedHole& hole : plan.holes) {
    if (!hole.own_regions.empty()) pond = &hole;
  }
  ASSERT_NE(pond, nullptr);
  double linked = 0;
  for (const RimSegment& s : pond->own_regions[0]) {
    const double length = (plan.vertices[s.to].position - plan.vertices[s.from].position).norm();
    if (s.seam) linked += length;
    EXPECT_LT(length, 1.1);  // squares are a metre wide
  }
  EXPECT_GT(linked, 3.5);
}

// A pier between two bays ends beyond the grid line and short of the outline: there the bays are one.
TEST(OverlappingPlanTest, ATileThatFacesDownIsNotPaved) {
  SurveyedScene scene = OverlappingScene(kWaters, 10, 0.1);
  TriMesh turned = scene.tiles.at({0, 0});
  for (Triangle& t : turned.triangles) std::swap(t[1], t[2]);
  scene.tiles[{0, 0}] = turned;
  const Plan plan = PlanOf(SurveyScene(scene.grid, scene.tiles));
  EXPECT_TRUE(std::any_of(plan.left.begin(), plan.left.end(), [](const LeftOpen& left) {
    return left.hole < 0 && left.reason.find("faces down") != std::string::npos;
  }));
  for (const PlannedHole& hole : plan.holes) {
    if (hole.cell == CellId{0, 0}) {
      EXPECT_FALSE(hole.failure.empty());
    }
  }
}

// The surface of the piece to the east ends askew under a hole: a link runs back along the one edge that bounds it.
TEST(OverlappingPlanTest, ARegionThatIsThereBothWaysIsNone) {
  SurveyedScene scene = OverlappingScene({"######", "######", "######", "##.###", "######", "######"}, 6, 0.05, 2);
  int moved = 0;
  for (Point3& p : scene.tiles.at({0, 0}).points) {
    if ((p - Point3(2.95, 3.05, 0)).norm() > 1e-3) continue;
    p.x() = 2.8125;
    ++moved;
  }
  ASSERT_EQ(moved, 1);
  const Plan plan = PlanOf(SurveyScene(scene.grid, std::move(scene.tiles)));
  ASSERT_THAT(plan.holes, SizeIs(1));
  EXPECT_THAT(plan.holes[0].own_regions, SizeIs(0));
  EXPECT_NE(plan.holes[0].failure, "") << "not dropped in silence";
}

TEST(HoldTogetherTest, HolesThatAChainHoldsTogetherAreOne) {
  SurveyedScene scene =
      OverlappingScene({"#######", "#######", "#######", "#######", "#######", "#######", "#######",  //
                        "-------",                                                                    //
                        "#..#..#", "#..#..#", "#######", "#######", "#######", "#######", "#######"},
                       7, 0.1);
  for (Point3& p : scene.tiles.at({0, 0}).points) {
    if (p.x() > 2.9 && p.x() < 4.1 && p.y() > 7) p.y() = 7.05F;
  }
  const Plan plan = PlanOf(SurveyScene(scene.grid, std::move(scene.tiles)));
  ASSERT_THAT(plan.holes, SizeIs(1));
  EXPECT_NEAR(plan.holes[0].area, 8, 1) << "of both bays";
  EXPECT_NEAR(plan.holes[0].centre.x(), 3.5, 0.1) << "between them";
  EXPECT_THAT(plan.holes[0].own_regions, SizeIs(1));
}

Plan PlanIn(const SurveyedScene& scene, std::vector<Point2> ring) {
  PlanInput input = scene.Input();
  input.area.rings = {std::move(ring)};
  return MakePlan(input, {});
}

TEST_P(OwnRegionsTest, EndAtTheAreaWhateverTheMargin) {
  const double margin = GetParam();
  for (const int pieces : {1, 2}) {
    // It cuts the river off in the west and the lake in the north-east cell.
    const Plan plan =
        PlanIn(OverlappingScene(kWaters, 10, margin, pieces), {{1.6, 1}, {19, 1}, {19, 11.4}, {1.6, 11.4}});
    const std::vector<Point3> positions = Positions(plan);
    double area = 0;
    for (const PlannedHole& hole : plan.holes) {
      EXPECT_EQ(hole.failure, "");
      for (const auto& region : hole.own_regions) area += AreaOf(region, positions);
    }
    for (const PlanVertex& v : plan.vertices) {
      if (v.index >= 0 || v.follows < 0) continue;
      EXPECT_GT(v.position.x(), 1.5);
      EXPECT_LT(v.position.y(), 11.5);
    }
    // Up to a metre more where an edge crosses the area's.
    EXPECT_NEAR(area, 5 * (11.4 - 7) + 2 * (19 - 1.6), 3 + 40 * std::abs(margin)) << pieces;
  }
}

// Along the edge of an area that crosses a line between cells at a small angle there are no heights to go by.
TEST_P(OwnRegionsTest, HaveNoHeightsButThoseOfTheRim) {
  const double height = 5;
  const SurveyedScene scene = OverlappingScene(kWaters, 10, GetParam(), 1, [=](double, double) { return height; });
  for (const double turn : {0.001, 0.01, 0.05, 0.1, -0.001, -0.01, -0.05, -0.1}) {
    for (const double top : {8.4, 8.7, 9.2, 11.5, 19.0}) {
      // The lake is from 7 to 12 to the east, from 8 to 13 to the north.
      const Plan plan = PlanIn(scene, {{10 + turn, 1}, {19, 1}, {19, top}, {10 - turn, top}});
      int known = 0;
      for (const PlannedHole& hole : plan.holes) {
        EXPECT_EQ(hole.failure, "");
        for (const RimSegment& s : hole.own_regions.empty() ? hole.segments : hole.own_regions[0]) {
          const PlanVertex &v = plan.vertices[s.from], &next = plan.vertices[s.to];
          EXPECT_GT((v.position - next.position).head<2>().norm(), plan.lattice_step) << v.position.transpose();
          if (v.index < 0 && !v.height_known) continue;
          EXPECT_NEAR(v.position.z(), height, 1e-6) << turn << " " << top << ": " << v.position.transpose();
          ++known;
        }
      }
      EXPECT_GT(known, 5) << turn;
    }
  }
}

TEST_P(OwnRegionsTest, OfACellWithoutTileEndAtTheArea) {
  SurveyedScene scene = OverlappingScene(kWaters, 10, GetParam());
  scene.tiles.at({0, 0}) = {};
  scene = SurveyScene(scene.grid, scene.tiles);
  const Plan plan = PlanIn(scene, {{4, 4}, {19, 4}, {19, 19}, {4, 19}});
  const std::vector<Point3> positions = Positions(plan);
  double area = 0;
  for (const PlannedHole& hole : plan.holes) {
    EXPECT_EQ(hole.failure, "");
    if (hole.cell == CellId{0, 0}) {
      for (const auto& region : hole.own_regions) area += AreaOf(region, positions);
    }
  }
  EXPECT_NEAR(area, (6 + GetParam()) * (6 + GetParam()), 0.1);
}

TEST_P(OwnRegionsTest, Close) {
  for (const int pieces : {1, 2}) {
    const Plan plan = PlanOf(OverlappingScene(kWaters, 10, GetParam(), pieces));
    for (const PlannedHole& hole : plan.holes) {
      for (const auto& region : hole.own_regions) {
        std::map<int32_t, int> balance;
        for (const RimSegment& s : region) ++balance[s.from], --balance[s.to];
        for (const auto& [v, more] : balance) EXPECT_EQ(more, 0) << plan.vertices[v].position.transpose();
      }
    }
  }
}

// A hole over a border whose east side is the outline of a piece.
TEST_P(OwnRegionsTest, GoAlongOutlinesOfPiecesToThatOfTheTile) {
  const std::string whole(10, '#'), hole = "###..#####";
  std::vector<std::string> picture(9, whole);
  for (const std::string& row : {hole, std::string("----------"), hole}) picture.push_back(row);
  picture.insert(picture.end(), 9, whole);
  const Plan plan = PlanOf(OverlappingScene(picture, 10, GetParam(), 2));
  int seams = 0;
  for (const PlannedHole& h : plan.holes) {
    for (const auto& region : h.own_regions) {
      for (const RimSegment& s : region) {
        if (!s.seam) continue;
        ++seams;
        const Point3 way = plan.vertices[s.to].position - plan.vertices[s.from].position;
        EXPECT_LT(std::min(std::abs(way.x()), std::abs(way.y())), 1e-3) << way.transpose();
      }
    }
  }
  EXPECT_GE(seams, 4);
}

TEST(BufferedTilesTest, HolesOverBordersAreFilledInEveryTile) {
  const Plan whole = PlanOf(PictureScene(kWaters, 10));
  for (const double margin : {0.0, 0.25, 1.0}) {
    const Plan plan = PlanOf(BufferedScene(kWaters, 10, margin));
    EXPECT_EQ(plan.clusters, whole.clusters);
    const std::vector<Point3> positions = Positions(plan);
    for (const PlannedHole& hole : plan.holes) {
      EXPECT_EQ(hole.failure, "");
      if (hole.kind == HoleKind::kClosed) continue;
      ASSERT_THAT(hole.own_regions, SizeIs(1));
      EXPECT_GE(AreaOf(hole.own_regions[0], positions), hole.area - 1e-3) << "up to its outline, not only to the line";
    }
  }
}

// A hole that ends where the neighbour has surface goes on below it, to its tile's own outline.
TEST_P(OwnRegionsTest, TellWhereTheNeighbourHasSurface) {
  const Plan plan = PlanOf(OverlappingScene(
      {"##########|##########", "##########|...#######", "##########|...#######", "##########|...#######",
       "##########|##########", "##########|##########", "##########|##########", "##########|##########",
       "##########|##########", "##########|##########"},
      10, GetParam()));
  ASSERT_THAT(plan.holes, SizeIs(1));
  ASSERT_THAT(plan.holes[0].own_regions, SizeIs(1));
  int64_t new_vertices = 0;
  for (const RimSegment& s : plan.holes[0].own_regions[0]) {
    const PlanVertex& v = plan.vertices[s.from];
    EXPECT_EQ(v.on_neighbour, v.index < 0) << v.position.transpose();
    new_vertices += v.index < 0;
  }
  EXPECT_GT(new_vertices, 0);
  for (const PlanVertex& v : PlanOf(OverlappingScene(kWaters, 10, GetParam())).vertices)
    EXPECT_FALSE(v.on_neighbour && v.index >= 0);
}

// Both neighbours' new vertices take the surface from the same places on the line between them.
TEST_P(OwnRegionsTest, OfNeighboursFollowTheSameVertices) {
  const Plan plan = PlanOf(OverlappingScene(kWaters, 10, GetParam()));
  std::map<int32_t, std::set<std::pair<double, double>>> followers;  // their places
  for (const PlanVertex& v : plan.vertices) {
    if (v.index >= 0 || v.follows < 0 || plan.vertices[v.follows].index >= 0) continue;
    followers[v.follows].insert({v.position.x(), v.position.y()});
  }
  ASSERT_FALSE(followers.empty());
  for (const auto& [vertex, places] : followers) {
    const Point3& p = plan.vertices[vertex].position;
    const bool inside = p.x() > 0 && p.x() < 20 && p.y() > 0 && p.y() < 20;
    const bool corner = plan.vertices[vertex].lines == 3;
    EXPECT_THAT(places, SizeIs(!inside ? 1 : corner ? 4 : 2)) << p.transpose();
  }
}

TEST_P(OwnRegionsTest, HolesOverTurnedPiecesOfOneTileAreFound) {
  for (const double angle : {0.0, -0.0178, 0.3}) {
    const Plan plan = PlanOf(TurnedPiecesScene(GetParam(), angle));
    EXPECT_NEAR(plan.remarks.piece_reach, 6 * GetParam(), 1e-3);
    for (const PlannedHole& hole : plan.holes) EXPECT_EQ(hole.failure, "") << angle;
    std::vector<double> areas;
    for (const PlannedHole& hole : plan.holes) areas.push_back(hole.area);
    std::ranges::sort(areas);
    const double margins = 4 * GetParam();  // pieces reach into the pond, too
    EXPECT_THAT(areas, ElementsAre(DoubleNear(4, 0.5), DoubleNear(32, 12 * margins))) << angle;
  }
}

INSTANTIATE_TEST_SUITE_P(Margins, OwnRegionsTest, ::testing::Values(0.05, 0.1, 0.25));

}  // namespace
}  // namespace tilemend
