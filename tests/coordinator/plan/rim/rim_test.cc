#include "coordinator/plan/rim/rim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "tests/support/rim_builders.h"
#include "tests/support/space_meshes.h"
#include "tests/support/surveyed_scene.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

using Picture = std::vector<std::string>;

double SignedArea(const Rim& rim, const std::vector<int32_t>& loop) {
  double area = 0;
  for (const int32_t e : loop) {
    const Point3 &a = rim.points[rim.edges[e].from].position, &b = rim.points[rim.edges[e].to].position;
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return area;
}

// By size: outlines are positive, holes negative.
std::multiset<double> Areas(const Rim& rim) {
  std::multiset<double> areas;
  for (const auto& loop : rim.loops) areas.insert(SignedArea(rim, loop));
  return areas;
}

Rim RimOfPicture(const Picture& picture, int32_t squares) {
  const SurveyedScene scene = PictureScene(picture, squares);
  return BuildRim(scene.Input());
}

TEST(BuildRimTest, DropsTheEdgesAtWhichTilesMeet) {
  const Rim rim = RimOfPicture({"##|##", "##|##", "--+--", "##|##", "##|##"}, 2);
  EXPECT_EQ(Areas(rim), std::multiset<double>{16});
  EXPECT_EQ(rim.edges.size(), 16U);
  EXPECT_TRUE(rim.unlinked.empty());
}

TEST(BuildRimTest, LinksTheRimToLoopsWithTheSurfaceOnTheLeft) {
  const Rim rim = RimOfPicture({"####|####", "#..#|####", "####|##..", "####|####"}, 4);
  EXPECT_EQ(Areas(rim), (std::multiset<double>{-2, 30}));
  for (const auto& loop : rim.loops) {
    for (size_t k = 0; k < loop.size(); ++k) {
      EXPECT_EQ(rim.edges[loop[k]].to, rim.edges[loop[(k + 1) % loop.size()]].from);
    }
  }
}

TEST(BuildRimTest, TurnsEachLoopBackIntoItsOwnHoleWhereHolesTouch) {
  const Rim rim = RimOfPicture({"####", "#.##", "##.#", "####"}, 4);
  EXPECT_EQ(Areas(rim), (std::multiset<double>{-1, -1, 16}));
  EXPECT_EQ(rim.continuous, 1);
}

TEST(BuildRimTest, CountsGroupsOfHolesThatTouch) {
  const Rim rim = RimOfPicture({"########", "#.####.#", "##.##.##", "########",  //
                                "########", "##..####", "########", "########"},
                               8);
  EXPECT_EQ(rim.loops.size(), 6U);
  EXPECT_EQ(rim.continuous, 2);
}

TEST(BuildRimTest, KnowsTheOwnerOfEachEdgeAndThePointOfEachBoundaryVertex) {
  const SurveyedScene scene = PictureScene({"##|##", "##|.."}, 2);
  const Rim rim = BuildRim(scene.Input());
  for (const RimEdge& e : rim.edges) {
    const TriMesh& tile = scene.tiles.at(e.owner);
    for (const int32_t p : {e.from, e.to}) {
      EXPECT_EQ(std::count(tile.points.begin(), tile.points.end(), rim.points[p].position), 1);
    }
  }
  for (const auto& [cell, points] : rim.point_of) {
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(rim.points[points[i]].position, scene.records.at(cell).vertices[i].position);
    }
  }
}

TEST(BuildRimTest, GivesEachPointTheMeanLengthOfItsEdges) {
  const Rim rim = RimOfPicture({"###", "#.#", "###"}, 3);
  for (const RimPoint& p : rim.points) {
    EXPECT_DOUBLE_EQ(p.size, 1);
    EXPECT_DOUBLE_EQ(p.reach, 1);
  }
}

TEST(BuildRimTest, EdgesOfWallsReachNoFartherThanTheyAreLongSeenFromAbove) {
  SurveyedScene scene = PictureScene({"####", "#..#", "#..#", "####"}, 4);
  for (Point3& p : scene.tiles.at({0, 0}).points) {
    if (p == Point3(1, 1, 0)) p.z() = 30;
  }
  const Rim rim = BuildRim(SurveyScene(scene.grid, std::move(scene.tiles)).Input());
  for (const RimPoint& p : rim.points) {
    if (p.position.z() == 0) continue;
    EXPECT_GT(p.size, 30);
    EXPECT_DOUBLE_EQ(p.reach, 1.5);
  }
}

TEST(BuildRimTest, LeavesChainsThatDoNotCloseUnlinked) {
  SurveyRecord record;
  for (int32_t i = 0; i < 4; ++i) {
    record.vertices.emplace_back();
    record.vertices.back().position = Point3(i, i * i, 0);
  }
  record.edges = {{1, 2}, {0, 1}, {2, 3}};
  PlanInput input = CellsOf({{0, 0}}, 10);
  input.cells[{0, 0}] = &record;
  const Rim rim = BuildRim(input);
  EXPECT_TRUE(rim.loops.empty());
  EXPECT_EQ(rim.unlinked.size(), 3U);
}

// Squares, and beside them squares of half the size: every second vertex lies on an edge, `off` beside it.
TriMesh SheetWithASeam(double off) {
  TriMesh mesh = SquaresMesh(0, 3, 0, 4, [](int32_t, int32_t) { return true; });
  TriMesh fine = SquaresMesh(0, 6, 0, 8, [](int32_t, int32_t) { return true; });
  for (Point3& p : fine.points) {
    const bool is_beside = p.x() == 0 && std::fmod(p.y(), 2) == 1;
    p = Point3(3 + p.x() / 2 + (is_beside ? off : 0), p.y() / 2, 0);
  }
  AddMesh(fine, mesh);
  return mesh;
}

TEST(LinkLoopsTest, FindsTheHolesBetweenEdgesThatLieOnEachOther) {
  for (const double off : {0.0, 0.01, -0.01}) {
    const SurveyRecord record = SurveyTile(SheetWithASeam(off), false);
    PlanInput input;
    input.has_grid = false;
    input.cells[CellId{0, 0}] = &record;
    Rim rim = BuildRim(input);
    LinkLoops(rim, record.edge_after);
    const std::multiset<double> areas = Areas(rim);
    ASSERT_EQ(areas.size(), 5U) << off;
    EXPECT_NEAR(*areas.rbegin(), 24, 1e-9);
    EXPECT_NEAR(*areas.begin(), off > 0 ? -off / 2 : std::abs(off / 2) * (off < 0 ? 1 : 0), 1e-9);
  }
}

TEST(ReversedTest, WalksTheOtherWayAlongTheEdges) {
  const Rim rim = RimOf({{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}}});
  const std::vector<RimSegment> segments = Reversed(rim, rim.loops[0]);
  ASSERT_EQ(segments.size(), 3U);
  EXPECT_EQ(segments[0].from, 0);
  EXPECT_EQ(segments[0].to, 2);
  for (size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(segments[k].to, segments[(k + 1) % 3].from);
    EXPECT_FALSE(segments[k].seam);
  }
}

// Cells of surface whose holes lie in the middle of each third one and over each fifth border.
Picture ManyCells(int columns, int rows) {
  constexpr int kSide = 4;
  Picture picture;
  for (int y = 0; y < rows * kSide; ++y) {
    if (y > 0 && y % kSide == 0) picture.emplace_back(static_cast<size_t>(columns * (kSide + 1) - 1), '-');
    std::string& row = picture.emplace_back();
    for (int x = 0; x < columns * kSide; ++x) {
      if (x > 0 && x % kSide == 0) row += '|';
      const int cell = x / kSide + y / kSide;
      const bool inside = cell % 3 == 0 && x % kSide == 1 && y % kSide == 2;
      const bool over_border = y % kSide == 1 && (((x + 1) % kSide == 0 && cell % 5 == 0 && x + 1 < columns * kSide) ||
                                                  (x % kSide == 0 && x > 0 && (cell - 1) % 5 == 0));
      row += inside || over_border ? '.' : '#';
    }
  }
  return picture;
}

TEST(BuildRimTest, IsTheSameRimWhetherOrNotPointsWithoutEdgesAreLeftOut) {
  const SurveyedScene scene = PictureScene(ManyCells(70, 60), 4);  // tidied up several times on the way
  const PlanInput input = scene.Input();
  const Rim all = BuildRim(input, RimPoints::kAll), rim = BuildRim(input, RimPoints::kOfEdges);
  EXPECT_LT(rim.points.size(), all.points.size() / 2);
  ASSERT_EQ(rim.edges.size(), all.edges.size());
  for (size_t e = 0; e < rim.edges.size(); ++e) {
    EXPECT_EQ(rim.points[rim.edges[e].from].position, all.points[all.edges[e].from].position);
    EXPECT_EQ(rim.points[rim.edges[e].to].normal, all.points[all.edges[e].to].normal);
  }
  EXPECT_EQ(rim.loops, all.loops);
  int64_t gone = 0;
  for (const auto& [cell, points] : rim.point_of) {
    const SurveyRecord& record = scene.records.at(cell);
    ASSERT_EQ(points.size(), record.vertices.size());
    for (size_t v = 0; v < points.size(); ++v) {
      gone += points[v] < 0;
      if (points[v] < 0) continue;
      EXPECT_EQ(rim.points[points[v]].position, record.vertices[v].position);
    }
  }
  EXPECT_GT(gone, 0);
  EXPECT_LT(rim.point_of.size(), scene.records.size());
}

}  // namespace
}  // namespace tilemend
