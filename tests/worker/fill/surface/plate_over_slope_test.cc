#include "worker/fill/surface/plate_over_slope.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/hillside.h"
#include "tests/worker/fill/surface/plates.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

using testing::Everywhere, testing::Hills, testing::LargestError, testing::MakePlate, testing::Nowhere, testing::Plate;

bool Solve(ThinPlateProblem& problem) { return SolveThinPlate(problem).has_value(); }

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

double Hillside(double x, double y) { return HillsOnASlope(x, y, 1.5, 7); }

TEST(PlateOverSlopeTest, BendsAlongTheSlope) {
  Plate over_slope = MakePlate(Hillside, Everywhere, Nowhere), over_ground = over_slope;
  ASSERT_TRUE(SolveOverSlope({1, 0}, over_slope.problem, [&] { return Solve(over_slope.problem); }));
  ASSERT_TRUE(Solve(over_ground.problem));
  EXPECT_LT(LargestError(over_slope, Hillside), 0.6 * LargestError(over_ground, Hillside));
}

TEST(PlateOverSlopeTest, SaysWhatTheSolverSays) {
  Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  EXPECT_FALSE(SolveOverSlope({0.5, 0}, plate.problem, [] { return false; }));
}

}  // namespace
}  // namespace tilemend
