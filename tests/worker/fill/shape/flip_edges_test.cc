#include "worker/fill/shape/flip_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace tilemend {
namespace {

using ::testing::UnorderedElementsAre;

const auto kAnyEdge = [](int32_t, int32_t) { return true; };

// A patch over the lattice, one metre a step.
struct Patch {
  std::vector<LatticePoint> plane;
  std::vector<Triangle> triangles;
  std::vector<RegionSegment> walls;
  std::function<double(double, double)> height;

  std::vector<Triangle> Flipped(const std::function<bool(int32_t, int32_t)>& may_join = kAnyEdge) const {
    std::vector<Point3> points;
    for (const LatticePoint& p : plane) {
      const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
      points.emplace_back(x, y, height(x, y));
    }
    std::vector<Triangle> flipped = FlipForShape(triangles, plane, points, walls, may_join);
    for (Triangle& t : flipped) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return flipped;
  }
};

double Flat(double, double) { return 0; }
// Stretches along x, by 10.
double SteepInX(double x, double) { return 10 * x; }

// A square with its corners on the axes, parted along y = 0.
Patch Diamond() { return {{{-10, 0}, {0, -10}, {10, 0}, {0, 10}}, {{0, 2, 3}, {0, 1, 2}}, {}, SteepInX}; }

TEST(FlipForShapeTest, TakesTheDiagonalThatIsShorterInSpace) {
  EXPECT_THAT(Diamond().Flipped(), UnorderedElementsAre(Triangle{0, 1, 3}, Triangle{1, 2, 3}));
}

TEST(FlipForShapeTest, KeepsTheTrianglesOfAFlatPatch) {
  Patch patch = Diamond();
  patch.height = Flat;
  EXPECT_THAT(patch.Flipped(), UnorderedElementsAre(Triangle{0, 2, 3}, Triangle{0, 1, 2}));
}

TEST(FlipForShapeTest, KeepsWalls) {
  Patch patch = Diamond();
  patch.walls = {{2, 0}};
  EXPECT_THAT(patch.Flipped(), UnorderedElementsAre(Triangle{0, 2, 3}, Triangle{0, 1, 2}));
}

TEST(FlipForShapeTest, JoinsNoPointsThatMustNotBeJoined) {
  const auto not_1_and_3 = [](int32_t a, int32_t b) { return std::minmax(a, b) != std::minmax(1, 3); };
  EXPECT_THAT(Diamond().Flipped(not_1_and_3), UnorderedElementsAre(Triangle{0, 2, 3}, Triangle{0, 1, 2}));
}

TEST(FlipForShapeTest, TurnsNoTriangleOver) {
  Patch patch = Diamond();
  patch.plane[0] = {0, 0};  // now on the line from 1 to 3
  EXPECT_THAT(patch.Flipped(), UnorderedElementsAre(Triangle{0, 2, 3}, Triangle{0, 1, 2}));
}

TEST(FlipForShapeTest, MakesNoSharperEdge) {
  Patch patch = Diamond();
  // The worse shape would rise from 0.45 to 0.55, and the angle between the triangles from 103 to 120 degrees.
  patch.height = [](double x, double y) { return x < 0 ? 20 : x > 0 ? -28 : y < 0 ? 28 : 29; };
  EXPECT_THAT(patch.Flipped(), UnorderedElementsAre(Triangle{0, 2, 3}, Triangle{0, 1, 2}));
}

TEST(FlipForShapeTest, LeavesWhatIsNoManifoldAsItIs) {
  Patch patch = Diamond();
  patch.plane.push_back({0, 20});
  patch.triangles.push_back({0, 2, 4});  // a third triangle at the edge
  EXPECT_THAT(patch.Flipped(), UnorderedElementsAre(Triangle{0, 2, 3}, Triangle{0, 1, 2}, Triangle{0, 2, 4}));
}

// A square of squares under a surface that is steep along its diagonal.
Patch Hillside(int32_t side) {
  Patch patch;
  for (int32_t y = 0; y <= side; ++y) {
    for (int32_t x = 0; x <= side; ++x) patch.plane.push_back({10 * x, 10 * y});
  }
  for (int32_t y = 0; y < side; ++y) {
    for (int32_t x = 0; x < side; ++x) {
      const int32_t a = y * (side + 1) + x, c = a + side + 1;
      patch.triangles.push_back({a, a + 1, c + 1});
      patch.triangles.push_back({a, c + 1, c});
    }
  }
  patch.height = [](double x, double y) { return 3 * (x + y); };
  return patch;
}

TEST(FlipForShapeTest, KeepsAreaAndCornersOfALargePatch) {
  const Patch patch = Hillside(12);
  const std::vector<Triangle> flipped = patch.Flipped();
  ASSERT_EQ(flipped.size(), patch.triangles.size());
  std::vector<int> uses(patch.plane.size(), 0);
  int64_t twice_area = 0;
  for (const Triangle& t : flipped) {
    const LatticePoint &a = patch.plane[t[0]], &b = patch.plane[t[1]], &c = patch.plane[t[2]];
    const int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    EXPECT_GT(area, 0);
    twice_area += area;
    for (const int32_t v : t) ++uses[v];
  }
  EXPECT_EQ(twice_area, 2 * 120 * 120);
  EXPECT_EQ(std::count(uses.begin(), uses.end(), 0), 0);
  EXPECT_THAT(flipped, ::testing::Contains(Triangle{1, 14, 13}));  // the diagonals that run along the slope are gone
}

TEST(FlipForShapeTest, IsDoneAfterOneCall) {
  Patch patch = Hillside(12);
  const std::vector<Triangle> once = patch.Flipped();
  ASSERT_NE(once, patch.triangles);
  patch.triangles = once;
  EXPECT_EQ(patch.Flipped(), once);
}

}  // namespace
}  // namespace tilemend
