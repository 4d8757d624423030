#include "common/assemble/level_region.h"

#include <gtest/gtest.h>

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
