#include "worker/fill/region/smooth_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "tests/worker/fill/region/scattered_region.h"

namespace tilemend::internal {
namespace {

using testing::CheckDelaunay;
using testing::CheckTopology;
using testing::Scattered;
using testing::ScatteredRegion;

struct Rounds {
  int even;
  int shape;
};

// Squares whose points lie differently, each smoothed in three ways.
class SmoothRegionTest : public ::testing::TestWithParam<uint32_t> {
 protected:
  ScatteredRegion before_ = Scattered(12, GetParam(), GetParam());
};

constexpr Rounds kWays[] = {{2, 0}, {0, 2}, {2, 1}};

ScatteredRegion Smoothed(ScatteredRegion region, Rounds rounds) {
  SmoothRegion(region.mesh(), region.first, region.size, rounds.even, rounds.shape);
  return region;
}

// 1 for an equilateral triangle.
double Shape(Point32 a, Point32 b, Point32 c) {
  const auto length = [](Point32 p, Point32 q) { return std::hypot(double{1} * p.x - q.x, double{1} * p.y - q.y); };
  const double ab = length(a, b), bc = length(b, c), ca = length(c, a);
  return 2 * std::numbers::sqrt3 * static_cast<double>(Turn(a, b, c)) / (ab * ab + bc * bc + ca * ca);
}

struct Shapes {
  double least = 1;
  double mean = 0;
};

Shapes ShapesOf(const DelaunayMesh& mesh) {
  Shapes shapes;
  for (const MeshTriangle& t : mesh.triangles) {
    const double shape = Shape(mesh.points[t.corner[0]], mesh.points[t.corner[1]], mesh.points[t.corner[2]]);
    shapes.least = std::min(shapes.least, shape);
    shapes.mean += shape / static_cast<double>(mesh.triangles.size());
  }
  return shapes;
}

TEST_P(SmoothRegionTest, MovesInnerPointsOnly) {
  for (const Rounds rounds : kWays) {
    const ScatteredRegion after = Smoothed(before_, rounds);
    ASSERT_EQ(after.mesh().points.size(), before_.mesh().points.size());
    size_t moved = 0;
    for (size_t v = 0; v < after.mesh().points.size(); ++v) {
      if (after.mesh().points[v] == before_.mesh().points[v]) continue;
      EXPECT_GE(v, before_.first);
      ++moved;
    }
    EXPECT_GT(moved, (after.mesh().points.size() - after.first) / 2);
  }
}

TEST_P(SmoothRegionTest, TheTrianglesStillCoverTheRegionAndAreDelaunay) {
  for (const Rounds rounds : kWays) {
    const ScatteredRegion after = Smoothed(before_, rounds);
    const RegionTriangulation triangulation = ExportRegion(after.region, after.segments.size());
    ASSERT_NO_FATAL_FAILURE(CheckTopology(after.Points(), after.segments, triangulation));
    ASSERT_NO_FATAL_FAILURE(CheckDelaunay(after.Points(), triangulation));
    EXPECT_EQ(triangulation.triangles.size(), before_.mesh().triangles.size());
  }
}

TEST_P(SmoothRegionTest, TheWorstTriangleIsNoWorseAndTheMeanBetter) {
  for (const Rounds rounds : kWays) {
    const Shapes before = ShapesOf(before_.mesh()), after = ShapesOf(Smoothed(before_, rounds).mesh());
    EXPECT_GE(after.least, before.least);
    EXPECT_GT(after.mean, before.mean + 0.02);
  }
}

TEST_P(SmoothRegionTest, GivesTheSameEachTime) {
  const ScatteredRegion once = Smoothed(before_, {2, 1}), again = Smoothed(before_, {2, 1});
  EXPECT_EQ(once.mesh().points, again.mesh().points);
  for (size_t t = 0; t < once.mesh().triangles.size(); ++t) {
    EXPECT_EQ(once.mesh().triangles[t].corner, again.mesh().triangles[t].corner);
  }
}

TEST_P(SmoothRegionTest, AQuarterTurnTurnsTheResult) {
  const auto turned = [](Point32 p) { return Point32{-p.y, p.x}; };
  ScatteredRegion other = before_;
  for (Point32& p : other.mesh().points) p = turned(p);
  const ScatteredRegion after = Smoothed(before_, {2, 1});
  other = Smoothed(other, {2, 1});
  for (size_t v = 0; v < after.mesh().points.size(); ++v) {
    EXPECT_EQ(other.mesh().points[v], turned(after.mesh().points[v]));
  }
}

INSTANTIATE_TEST_SUITE_P(Places, SmoothRegionTest, ::testing::Range(1U, 6U));

// The best place of the one point of a hexagon, by either measure, is its centre.
TEST(SmoothFewPointsTest, ALonePointFindsTheCentreOfAHexagon) {
  testing::Region hexagon;
  std::vector<LatticePoint> loop;
  for (int i = 0; i < 6; ++i) {
    const double angle = i * std::numbers::pi / 3;
    loop.push_back({std::llround(1e6 * std::cos(angle)), std::llround(1e6 * std::sin(angle))});
  }
  hexagon.Loop(loop).points.push_back({350'000, 200'000});
  const std::vector<double> size(7, 1e6);
  for (const Rounds rounds : {Rounds{30, 0}, Rounds{0, 30}}) {
    RegionMesh region = BuildRegionMesh(hexagon.points, hexagon.segments);
    SmoothRegion(region.mesh, 6, size, rounds.even, rounds.shape);
    EXPECT_NEAR(region.mesh.points[6].x, 0, 10);
    EXPECT_NEAR(region.mesh.points[6].y, 0, 10);
    EXPECT_EQ(region.mesh.triangles.size(), 6U);
  }
}

std::vector<Triangle> Corners(const DelaunayMesh& mesh) {
  std::vector<Triangle> corners;
  for (const MeshTriangle& t : mesh.triangles) corners.push_back(t.corner);
  return corners;
}

// Between spikes the mean of the circumcentres, and the way uphill, often lead to worse triangles. Flips are made for
// angles, not for shapes: only stars without any tell what a move does.
TEST(SmoothFewPointsTest, NoMoveMakesTheWorstShapeWorseThanAGoodOne) {
  int moved = 0;
  for (uint32_t seed = 1; seed <= 200; ++seed) {
    testing::Region star = testing::RandomStar(seed, 14, 1e6);
    star.points.push_back({20'000, 10'000});
    const std::vector<double> size(star.points.size(), 1e6);
    for (const Rounds rounds : {Rounds{1, 0}, Rounds{0, 1}}) {
      RegionMesh region = BuildRegionMesh(star.points, star.segments);
      const DelaunayMesh before = region.mesh;
      SmoothRegion(region.mesh, star.points.size() - 1, size, rounds.even, rounds.shape);
      if (region.mesh.points == before.points || Corners(region.mesh) != Corners(before)) continue;
      ++moved;
      EXPECT_GE(ShapesOf(region.mesh).least, std::min(ShapesOf(before).least, 0.7)) << "star " << seed;
    }
  }
  EXPECT_GT(moved, 20);
}

TEST(SmoothFewPointsTest, WithoutInnerPointsNothingMoves) {
  const testing::Region square = testing::Square(0, 0, 1000);
  RegionMesh region = BuildRegionMesh(square.points, square.segments);
  const std::vector<Point32> before = region.mesh.points;
  SmoothRegion(region.mesh, 4, std::vector<double>(4, 1000), 2, 2);
  EXPECT_EQ(region.mesh.points, before);
}

}  // namespace
}  // namespace tilemend::internal
