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

}  // namespace
}  // namespace tilemend
