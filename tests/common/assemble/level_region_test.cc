#include "common/assemble/level_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "common/mesh/triangulation/region_triangulation.h"
#include "common/mesh/winding/wound_region.h"

namespace tilemend {
namespace {

// Adds a square with its lower left corner at (x, y).
std::vector<DirectedEdge> Square(LevelRegion& region, double x, double y, double side) {
  const int32_t first = region.Add({x, y});
  region.Add({x + side, y});
  region.Add({x + side, y + side});
  region.Add({x, y + side});
  return {{first, first + 1}, {first + 1, first + 2}, {first + 2, first + 3}, {first + 3, first}};
}

double AreaOf(const LevelRegion& region, const std::vector<DirectedEdge>& edges) {
  double twice = 0;
  for (const DirectedEdge& e : edges) {
    const Point2 a = region.At(e.from), b = region.At(e.to);
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

class LevelRegionTest : public ::testing::Test {
 protected:
  LevelRegion region_{LatticeWindow({0, 0}, {20, 20})};
  const std::vector<DirectedEdge> a_ = Square(region_, 2, 2, 8), b_ = Square(region_, 6, 6, 8);
};

TEST_F(LevelRegionTest, JoinsAndCuts) {
  EXPECT_NEAR(AreaOf(region_, region_.Both(a_, b_)), 16, 1e-4);
  EXPECT_NEAR(AreaOf(region_, region_.Either(a_, b_)), 112, 1e-4);
  EXPECT_NEAR(AreaOf(region_, region_.Without(a_, b_)), 48, 1e-4);
  EXPECT_TRUE(region_.Without(a_, a_).empty());
}

TEST_F(LevelRegionTest, GrowsToAllSides) { EXPECT_NEAR(AreaOf(region_, region_.Grown(a_, 1)), 100, 1e-4); }

TEST_F(LevelRegionTest, TakesTheFirstOfPointsAtOnePlace) {
  const std::vector<DirectedEdge> again = Square(region_, 2, 2, 8);
  const std::vector<DirectedEdge> first = region_.AtFirstPoints(again);
  for (size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].from, a_[i].from);
    EXPECT_EQ(first[i].to, a_[i].to);
  }
}

TEST_F(LevelRegionTest, FindsTheHolesThatLoopsBound) {
  const auto loop = [&](double x, double y, double side, bool is_island) {
    std::vector<int32_t> corners;
    for (const DirectedEdge& e : Square(region_, x, y, side)) corners.push_back(e.from);
    if (is_island) std::reverse(corners.begin(), corners.end());
    return corners;
  };
  // An island with a pond that has an island of its own, another hole, and a loop around nothing.
  const std::vector<std::vector<int32_t>> loops = {loop(2, 2, 1, true),   loop(0, 0, 10, false),
                                                   loop(1, 1, 8, true),   loop(1.5, 1.5, 6, false),
                                                   loop(12, 2, 5, false), loop(15, 15, 2, true)};
  EXPECT_EQ(region_.HolesOf(loops), (std::vector<std::vector<int32_t>>{{1, 2}, {3, 0}, {4}}));
}

TEST_F(LevelRegionTest, AnIslandThatTouchesItsHoleIsInIt) {
  const int32_t first = region_.Add({0, 0});
  for (const Point2& p : {Point2(8, 0), Point2(8, 8), Point2(0, 8), Point2(3, 5)}) region_.Add(p);
  const std::vector<std::vector<int32_t>> loops = {{first, first + 1, first + 2, first + 3},
                                                   {first, first + 4, first + 2}};
  EXPECT_EQ(region_.HolesOf(loops).size(), 1u) << "the second runs clockwise";
  EXPECT_EQ(region_.HolesOf(loops)[0], (std::vector<int32_t>{0, 1}));
}

// Rounding can leave an island beside the outer loop: an edge of one is that of the other, the other way.
TEST_F(LevelRegionTest, LoopsThatRunAlongEachOtherBoundARegionWithoutTheirCommonEdges) {
  const int32_t v = region_.Add({0, 0});
  for (const Point2& p : {Point2(3, 0), Point2(5, 0), Point2(8, 0), Point2(8, 8), Point2(0, 8), Point2(4, 2)}) {
    region_.Add(p);
  }
  std::vector<DirectedEdge> edges;
  for (int32_t i = 0; i < 6; ++i) edges.push_back({v + i, v + (i + 1) % 6});
  edges.insert(edges.end(), {{v + 1, v + 6}, {v + 6, v + 2}, {v + 2, v + 1}});
  EXPECT_FALSE(TriangulateRegion(region_.points(), edges).conflicts.empty());
  std::vector<DirectedEdge> simple;
  for (const std::vector<int32_t>& loop : LoopsBetween(edges, {})) {
    for (size_t i = 0; i < loop.size(); ++i) simple.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
  EXPECT_TRUE(TriangulateRegion(region_.points(), simple).conflicts.empty());
  EXPECT_NEAR(AreaOf(region_, simple), 62, 1e-4);
}

TEST(FacingUpTest, WindsAroundAllThatIsCovered) {
  // A square, and one that faces down and lies over a quarter of it and beyond. A wall.
  const TriMesh mesh = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, 1}, {6, 2, 1}, {6, 6, 1}, {2, 6, 1}},
                        {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}, {0, 2, 6}}};
  const std::vector<Triangle> up = FacingUp(mesh, mesh.triangles);
  EXPECT_EQ(up.size(), 4u);
  LevelRegion region(LatticeWindow({0, 0}, {6, 6}));
  const SurfaceOutline outline = SurfaceOutlineOf(up, [&](int32_t v) { return mesh.points[v]; });
  EXPECT_NEAR(AreaOf(region, region.Simple(EdgesFrom(outline, region.AddAll(outline)))), 28, 1e-4);
}

TEST(SurfaceOutlineTest, DoubledVerticesAndSharedEdgesAreNone) {
  // Two triangles of a square that each have their own vertices.
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 4, 5}, {0, 3, 1}};
  const SurfaceOutline outline = SurfaceOutlineOf(triangles, [&](int32_t v) { return points[v]; });
  EXPECT_EQ(outline.positions.size(), 4u);
  EXPECT_EQ(outline.vertex, (std::vector<int32_t>{0, 1, 2, 5}));
  EXPECT_EQ(outline.edges.size(), 4u);
  EXPECT_EQ(EdgesFrom(outline, 10)[0].from, 10 + outline.edges[0].from);
}

}  // namespace
}  // namespace tilemend
