#include "coordinator/plan/overlap/piece_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

const std::vector<std::string> kWhole(20, std::string(20, '#'));

int64_t CountOutlines(const SurveyRecord& record, double reach) {
  const std::vector<bool> found = FindPieceOutlines(record, {reach});
  return std::count(found.begin(), found.end(), true);
}

TEST(PieceOutlinesTest, AreWhereOnePieceEndsAndAnotherBegins) {
  const SurveyedScene scene = OverlappingScene(kWhole, 20, 0.1, 2);
  const SurveyRecord& record = scene.records.begin()->second;
  const std::vector<bool> found = FindPieceOutlines(record, {0.6});
  for (size_t e = 0; e < found.size(); ++e) {
    const Point3 &a = record.vertices[record.edges[e].from].position, &b = record.vertices[record.edges[e].to].position;
    const auto inner = [&](int k) {
      return std::abs(a[k] - b[k]) < 1e-3 && (std::abs(a[k] - 9.9) < 1e-3 || std::abs(a[k] - 10.1) < 1e-3);
    };
    EXPECT_EQ(found[e], inner(0) || inner(1)) << a.transpose() << " to " << b.transpose();
  }
}

TEST(PieceOutlinesTest, AreNotFartherApartThanTheReach) {
  const SurveyedScene scene = OverlappingScene(kWhole, 20, 0.1, 2);
  EXPECT_EQ(CountOutlines(scene.records.begin()->second, 0.1), 0);
  EXPECT_EQ(CountOutlines(OverlappingScene(kWhole, 20, 0.1).records.begin()->second, 0.6), 0) << "one piece";
}

// Pieces above each other, as an octree has them on a slope.
TEST(PieceOutlinesTest, AreLevelToo) {
  TriMesh tile;
  for (const bool upper : {false, true}) {
    const int32_t from = upper ? 10 : 0, to = upper ? 20 : 10;
    const TriMesh piece =
        Moved(SquaresMesh(from, to, 0, 20, [](int32_t, int32_t) { return true; }), [&](const Point3& p) {
          double x = p.x();
          if (upper && p.x() == 10) x -= 0.05;
          if (!upper && p.x() == 10) x += 0.05;
          return Point3(x, p.y(), x);
        });
    const auto base = static_cast<int32_t>(tile.points.size());
    tile.points.insert(tile.points.end(), piece.points.begin(), piece.points.end());
    for (const Triangle& t : piece.triangles) tile.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  Grid grid;
  grid.cell_size = Point2(20, 20);
  SurveyedScene scene = SurveyScene(grid, {{{0, 0}, tile}});
  SurveyRecord& record = scene.records.begin()->second;
  for (BoundaryVertex& v : record.vertices) std::swap(v.position.x(), v.position.z());  // seen from the side
  EXPECT_EQ(CountOutlines(record, 0.6), 2 * 20);
}

// A wall over y = 0 from x = 0 to 20 in two pieces, which end at z = 10 + overlap and begin at z = 10; at x = 0 they
// are joined by a strip, as where the next leaf of the octree shares vertices with both.
SurveyRecord JoinedWall(double overlap) {
  SurveyRecord record;
  const auto add_edge = [&](const Point3& from, const Point3& to) {
    const auto base = static_cast<int32_t>(record.vertices.size());
    for (const Point3& p : {from, to}) {
      BoundaryVertex& vertex = record.vertices.emplace_back();
      vertex.position = p;
      vertex.normal = Eigen::Vector3d(0, -1, 0);
    }
    BoundaryEdge& edge = record.edges.emplace_back();
    edge.from = base;
    edge.to = base + 1;
  };
  for (int x = 0; x < 20; ++x) {
    add_edge(Point3(x, 0, 10), Point3(x + 1, 0, 10));                      // the upper piece begins
    add_edge(Point3(x + 1, 0, 10 + overlap), Point3(x, 0, 10 + overlap));  // the lower one ends
  }
  add_edge(Point3(0, 0, 0), Point3(20, 0, 0));
  add_edge(Point3(20, 0, 20), Point3(0, 0, 20));
  return record;
}

TEST(PieceOutlinesTest, AreFoundWherePiecesAreJoinedBeyond) {
  const SurveyRecord record = JoinedWall(0.1);
  const std::vector<bool> found = FindPieceOutlines(record, {0.3});
  EXPECT_EQ(std::ranges::count(found, true), 40);
  EXPECT_FALSE(found[40] || found[41]) << "where the wall itself ends";
  EXPECT_EQ(CountOutlines(JoinedWall(0.5), 0.3), 0) << "too far apart";
}

// The boundary of a slit in the wall, which is no overlap.
TEST(PieceOutlinesTest, AreNotWhereSurfaceIsMissing) {
  EXPECT_EQ(CountOutlines(JoinedWall(-0.1), 0.3), 0);
  EXPECT_EQ(CountOutlines(JoinedWall(0.01), 0.3), 0) << "level to a few millimetres, as by chance";
}

// A tile with a buffer of a metre, where a hole reaches to two metres from its southern end: the surface left between
// is a strip. Straight boundaries run along each other there, as at the outlines of pieces, but no surface lies double.
TEST(PieceOutlinesTest, AreNotTheSidesOfANarrowStrip) {
  const auto is_there = [](int32_t x, int32_t y) { return !(x >= 4 && x < 16 && (y == 2 || (y > 4 && y < 9))); };
  const TriMesh tile = SquaresMesh(0, 20, 0, 20, is_there);
  Grid grid;
  grid.cell_size = Point2(20, 20);
  const SurveyedScene scene = SurveyScene(grid, {{{0, 0}, tile}});
  EXPECT_EQ(CountOutlines(scene.records.begin()->second, 3), 0);
}

// Loose triangles at the water have level edges by chance.
TEST(PieceOutlinesTest, AreNotSingleEdges) {
  SurveyRecord record;
  const auto add = [&](const std::array<Point3, 3>& corners, int32_t piece) {
    const auto base = static_cast<int32_t>(record.vertices.size());
    for (int32_t k = 0; k < 3; ++k) {
      record.vertices.emplace_back().position = corners[static_cast<size_t>(k)];
      BoundaryEdge& edge = record.edges.emplace_back();
      edge.from = base + k;
      edge.to = base + (k + 1) % 3;
      edge.piece = piece;
    }
  };
  add({Point3(0, 0, 11.442), Point3(1.5, 0.1, 11.442), Point3(0.7, 1.2, 11.5)}, 0);
  add({Point3(0.7, 1.2, 11.5), Point3(2.2, 1.3, 11.5), Point3(1.5, 2.4, 11.3)}, 1);
  EXPECT_EQ(std::ranges::count(FindPieceOutlines(record, {0.2}), true), 0);
}

}  // namespace
}  // namespace tilemend
