#include "worker/fill/surface/two_level_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "tests/worker/fill/surface/plates.h"
#include "worker/fill/surface/coarse_plate.h"

namespace tilemend::internal {
namespace {

using testing::Everywhere;
using testing::LargestError;
using testing::MakePlate;
using testing::Nowhere;
using testing::Plate;

constexpr int32_t kLarge = 32;  // half a side: 3,969 unknown points

double Hills(double x, double y) { return std::sin(0.11 * x + 0.2) * std::cos(0.07 * y) + 0.001 * x * y; }
// With noise from point to point, as rims have it.
double RoughHills(double x, double y) { return Hills(x, y) + 0.05 * std::sin(37.1 * x + 91.7 * y); }

// Values without any pattern, zero at known points.
PointValues Noise(const ThinPlateProblem& problem, bool everywhere) {
  PointValues values(static_cast<Eigen::Index>(problem.points.size()));
  for (Eigen::Index v = 0; v < values.size(); ++v) {
    values[v] = everywhere || !problem.known[v] ? std::sin(12.9898 * static_cast<double>(v + 1) * (v % 7 + 1)) : 0;
  }
  return values;
}

class TwoLevelTest : public ::testing::TestWithParam<double> {};

TEST_P(TwoLevelTest, AgreesWithTheFactorisation) {
  Plate plate = MakePlate(RoughHills, Everywhere, Nowhere, kLarge);
  plate.problem.tension = GetParam();
  const PlateEquations equations(plate.problem, true, GetParam());
  const std::optional<PointValues> direct = SolveDirectly(plate.problem, equations);
  const std::optional<PointValues> iterated = SolveInTwoLevels(plate.problem, equations);
  ASSERT_TRUE(direct.has_value());
  ASSERT_TRUE(iterated.has_value());
  const PointValues error = *iterated - *direct;
  const double share = std::sqrt(error.dot(equations.Apply(error)) / equations.Energy(*direct));
  EXPECT_LT(share, 2 * kLeastError) << "the estimate that stops the iteration is too low";
  const double relief = direct->maxCoeff() - direct->minCoeff();
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 0.003 * relief);
}

INSTANTIATE_TEST_SUITE_P(Tensions, TwoLevelTest, ::testing::Values(0.0, 0.001, 0.1, 10.0));

TEST(SolveInTwoLevelsTest, KeepsAPlane) {
  const auto plane = [](double x, double y) { return 400 + 0.5 * x - 0.25 * y; };
  const Plate plate = MakePlate(plane, Everywhere, Nowhere, kLarge);
  const auto heights = SolveInTwoLevels(plate.problem, PlateEquations(plate.problem, true, 0));
  ASSERT_TRUE(heights.has_value());
  for (const auto& [place, v] : plate.at) {
    EXPECT_NEAR((*heights)[static_cast<Eigen::Index>(v)], plane(place.first, place.second), 1e-4);
  }
}

// An island of one point in the middle, 5 m up.
TEST(SolveInTwoLevelsTest, KeepsKnownPointsInside) {
  const auto middle = [](double x, double y) { return x == 0 && y == 0; };
  const auto height = [&](double x, double y) { return middle(x, y) ? 5.0 : 0.0; };
  const Plate plate = MakePlate(height, Everywhere, middle, kLarge);
  const PlateEquations equations(plate.problem, true, 0);
  const auto heights = SolveInTwoLevels(plate.problem, equations), direct = SolveDirectly(plate.problem, equations);
  ASSERT_TRUE(heights.has_value() && direct.has_value());
  EXPECT_EQ((*heights)[static_cast<Eigen::Index>(plate.at.at({0, 0}))], 5.0);
  EXPECT_LT((*heights - *direct).cwiseAbs().maxCoeff(), 0.02);
}

TEST(SolveInTwoLevelsTest, GivesTheSameHeightsEveryTime) {
  const Plate plate = MakePlate(RoughHills, Everywhere, Nowhere, kLarge);
  const PlateEquations equations(plate.problem, true, 0);
  EXPECT_EQ(*SolveInTwoLevels(plate.problem, equations), *SolveInTwoLevels(plate.problem, equations));
}

// What keeps cells independent, on plates that are large enough for two levels: heights and Laplacians on a cut give
// either side the surface of the whole.
TEST(SolveThinPlateTest, ALargeHalfIsNearTheWhole) {
  Plate whole = MakePlate(RoughHills, Everywhere, Nowhere, kLarge);
  const auto laplacian = SolveThinPlate(whole.problem);
  ASSERT_TRUE(laplacian.has_value());
  const auto on_cut = [](double x, double y) { return x == -8 && std::abs(y) <= kLarge; };
  Plate half = MakePlate(
      RoughHills, [](double x, double) { return x >= -8; }, on_cut, kLarge);
  half.problem.laplacian.resize(half.problem.points.size());
  for (const auto& [place, v] : half.at) {
    if (!on_cut(place.first, place.second)) continue;
    half.problem.points[v].z() = whole.problem.points[whole.at.at(place)].z();
    half.problem.laplacian[v] = (*laplacian)[whole.at.at(place)];
  }
  ASSERT_TRUE(SolveThinPlate(half.problem).has_value());
  constexpr double kRelief = 3;  // of the hills there
  double sum = 0, largest = 0;
  for (const auto& [place, v] : half.at) {
    const double error = std::abs(half.problem.points[v].z() - whole.problem.points[whole.at.at(place)].z());
    sum += error;
    largest = std::max(largest, error);
  }
  EXPECT_LT(sum / static_cast<double>(half.at.size()), 0.002 * kRelief);
  EXPECT_LT(largest, 0.01 * kRelief);
}

TEST(PlateEquationsTest, TheMatrixIsTheOperator) {
  for (const double tension : {0.0, 0.3}) {
    const Plate plate = MakePlate(Hills, Everywhere, Nowhere);
    const PlateEquations equations(plate.problem, true, tension);
    const PointValues x = Noise(plate.problem, false);
    const Eigen::VectorXd product = equations.LowerMatrix().selfadjointView<Eigen::Lower>() * equations.Gather(x);
    EXPECT_LT((product - equations.Gather(equations.Apply(x))).cwiseAbs().maxCoeff(), 1e-10);
    const Eigen::VectorXd diagonal = equations.LowerMatrix().diagonal();
    EXPECT_LT((diagonal - equations.Gather(equations.Diagonal())).cwiseAbs().maxCoeff(), 1e-10);
  }
}

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

}  // namespace
}  // namespace tilemend::internal
