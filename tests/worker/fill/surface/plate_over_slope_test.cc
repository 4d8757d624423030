#include "worker/fill/surface/plate_over_slope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/worker/fill/surface/plates.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

using testing::Everywhere, testing::Hills, testing::LargestError, testing::MakePlate, testing::Nowhere, testing::Plate;

std::optional<std::vector<double>> Solve(ThinPlateProblem& problem) { return SolveThinPlate(problem); }

TEST(PlateOverSlopeTest, OnLevelGroundChangesNothing) {
  Plate with = MakePlate(Hills, Everywhere, Nowhere), without = with;
  ASSERT_TRUE(SolveOverSlope({0, 0}, with.problem, [&] { return Solve(with.problem); }));
  ASSERT_TRUE(Solve(without.problem));
  EXPECT_EQ(with.problem.points, without.problem.points);
}

TEST(PlateOverSlopeTest, KeepsPlacesAndKnownHeights) {
  Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  const std::vector<Point3> before = plate.problem.points;
  ASSERT_TRUE(SolveOverSlope({0.7, -1.1}, plate.problem, [&] { return Solve(plate.problem); }));
  for (size_t v = 0; v < before.size(); ++v) {
    EXPECT_EQ(plate.problem.points[v].head<2>(), before[v].head<2>());
    if (plate.problem.known[v]) {
      EXPECT_EQ(plate.problem.points[v].z(), before[v].z());
    }
  }
}

TEST(PlateOverSlopeTest, GivesAPlaneOfAnySlope) {
  const auto plane = [](double x, double y) { return 3 + 1.3 * x - 0.4 * y; };
  Plate plate = MakePlate(plane, Everywhere, Nowhere);
  ASSERT_TRUE(SolveOverSlope({0.9, 0.2}, plate.problem, [&] { return Solve(plate.problem); }));
  EXPECT_LT(LargestError(plate, plane), 1e-9);
}

// Low hills on a slope of 45 degrees: as far apart as they are on the plane, and as high above it.
TEST(PlateOverSlopeTest, OverLowHillsIsThePlateOverThePlane) {
  const double length = std::sqrt(2.0);
  const auto hills = [](double u, double v) { return 0.03 * std::sin(0.16 * u + 0.4) * std::cos(0.14 * v); };
  const auto tilted = [&](double x, double y) { return x + length * hills(length * x, y); };
  Plate plate = MakePlate(tilted, Everywhere, Nowhere), over_plane = plate, over_ground = plate;
  for (size_t v = 0; v < plate.problem.points.size(); ++v) {
    Point3& p = over_plane.problem.points[v];
    p = {length * p.x(), p.y(), plate.problem.known[v] ? hills(length * p.x(), p.y()) : 0};
  }
  ASSERT_TRUE(SolveOverSlope({1, 0}, plate.problem, [&] { return Solve(plate.problem); }));
  ASSERT_TRUE(Solve(over_plane.problem));
  ASSERT_TRUE(Solve(over_ground.problem));
  double apart = 0, from_ground = 0;
  for (size_t v = 0; v < plate.problem.points.size(); ++v) {
    const Point3& p = plate.problem.points[v];
    apart = std::max(apart, std::abs(p.z() - p.x() - length * over_plane.problem.points[v].z()));
    from_ground = std::max(from_ground, std::abs(p.z() - over_ground.problem.points[v].z()));
  }
  EXPECT_GT(from_ground, 10 * apart);
}

// A gutter, level in its middle and of 43 degrees at its sides: no plane lies along all of it. Along it, it bends
// evenly.
TEST(PlateOverSlopeTest, BendsAlongASurfaceThatNoPlaneLiesAlong) {
  const auto gutter = [](double x, double) { return 16 - std::sqrt(16 * 16 - x * x); };
  Plate along = MakePlate(gutter, Everywhere, Nowhere), over_plane = along;
  ASSERT_TRUE(SolveOverSlope({0.3, 0}, along.problem, [&] { return Solve(along.problem); }));
  ASSERT_TRUE(Solve(over_plane.problem));
  EXPECT_LT(LargestError(along, gutter), 0.3 * LargestError(over_plane, gutter));
  EXPECT_TRUE(along.problem.along.empty());
}

TEST(PlateOverSlopeTest, SaysWhatTheSolverSays) {
  Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  EXPECT_FALSE(SolveOverSlope({0.5, 0}, plate.problem, [] { return std::nullopt; }));
}

}  // namespace
}  // namespace tilemend
