#include "worker/fill/surface/coarse_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "tests/worker/fill/surface/plates.h"

namespace tilemend {
namespace {

using testing::Everywhere;
using testing::Hills;
using testing::kLarge;
using testing::MakePlate;
using testing::Noise;
using testing::Nowhere;
using testing::Plate;

TEST(CoarsenPlateTest, ThinsTheInsideAndKeepsTheBoundary) {
  const Plate plate = MakePlate(Hills, Everywhere, Nowhere, kLarge);
  const std::optional<CoarsePlate> coarse = CoarsenPlate(plate.problem);
  ASSERT_TRUE(coarse.has_value());
  const PlateEquations fine(plate.problem, true, 0), few(coarse->problem, true, 0);
  EXPECT_LT(4 * few.unknown_count(), fine.unknown_count());
  int64_t known = 0, kept = 0;
  for (size_t v = 0; v < plate.problem.points.size(); ++v)
    known += plate.problem.known[v] && plate.problem.has_equation[v];
  for (size_t v = 0; v < coarse->problem.points.size(); ++v) {
    kept += coarse->problem.known[v] && coarse->problem.has_equation[v];
  }
  EXPECT_EQ(kept, known);
}

TEST(PlateInterpolationTest, KeepsLinearFunctions) {
  const Plate plate = MakePlate(Hills, Everywhere, Nowhere, kLarge);
  const std::optional<CoarsePlate> coarse = CoarsenPlate(plate.problem);
  ASSERT_TRUE(coarse.has_value());
  const auto linear = [](const Point3& p) { return 3 + 0.5 * p.x() - 0.2 * p.y(); };
  PointValues values(static_cast<Eigen::Index>(coarse->problem.points.size()));
  for (Eigen::Index v = 0; v < values.size(); ++v) values[v] = linear(coarse->problem.points[v]);
  const PointValues fine = coarse->interpolation.ToFine(values);
  for (size_t v = 0; v < plate.problem.points.size(); ++v) {
    const double expected = plate.problem.known[v] ? 0 : linear(plate.problem.points[v]);
    EXPECT_NEAR(fine[static_cast<Eigen::Index>(v)], expected, 1e-5);
  }
}

TEST(PlateInterpolationTest, TheWayBackIsTheTranspose) {
  const Plate plate = MakePlate(Hills, Everywhere, Nowhere, kLarge);
  const std::optional<CoarsePlate> coarse = CoarsenPlate(plate.problem);
  ASSERT_TRUE(coarse.has_value());
  const PointValues up = Noise(coarse->problem, true), down = Noise(plate.problem, false);
  const double there = coarse->interpolation.ToFine(up).dot(down);
  EXPECT_NEAR(there, up.dot(coarse->interpolation.ToCoarse(down)), 1e-9 * std::abs(there) + 1e-9);
}

TEST(CoarsenPlateTest, KeepsKnownPointsInside) {
  const auto middle = [](double x, double y) { return x == 0 && y == 0; };
  const Plate plate = MakePlate(Hills, Everywhere, middle, kLarge);
  const std::optional<CoarsePlate> coarse = CoarsenPlate(plate.problem);
  ASSERT_TRUE(coarse.has_value());
  bool found = false;
  for (size_t v = 0; v < coarse->problem.points.size(); ++v) {
    const Point3& p = coarse->problem.points[v];
    if (p.head<2>().isZero()) found = coarse->problem.known[v] && p.z() == Hills(0, 0);
  }
  EXPECT_TRUE(found);
}

TEST(CoarsenPlateTest, IsNothingWithoutAPatch) {
  Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  plate.problem.patch.clear();
  EXPECT_FALSE(CoarsenPlate(plate.problem).has_value());
}

TEST(CoarsenPlateTest, IsNothingForAPatchThatFoldsOver) {
  // Two triangles of a bow: their boundary crosses itself.
  ThinPlateProblem problem;
  problem.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {1, 1, 0}};
  problem.known.assign(5, true);
  problem.has_equation.assign(5, false);
  problem.patch = {{0, 3, 4}, {1, 2, 4}};
  EXPECT_FALSE(CoarsenPlate(problem).has_value());
}

}  // namespace
}  // namespace tilemend
