#include "worker/fill/surface/two_level_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "tests/worker/fill/surface/plates.h"
#include "worker/fill/surface/direct_solver.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

using testing::Everywhere;
using testing::kLarge;
using testing::MakePlate;
using testing::Nowhere;
using testing::Plate;
using testing::RoughHills;

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

TEST(SolveInTwoLevelsTest, AgreesAlongASurfaceToo) {
  Plate plate = MakePlate(RoughHills, Everywhere, Nowhere, kLarge);
  for (const Point3& p : plate.problem.points) plate.problem.along.emplace_back(p.x(), p.y(), 0.02 * p.x() * p.x());
  const PlateEquations equations(plate.problem, true, 0);
  const auto heights = SolveInTwoLevels(plate.problem, equations), direct = SolveDirectly(plate.problem, equations);
  ASSERT_TRUE(heights.has_value() && direct.has_value());
  EXPECT_LT((*heights - *direct).cwiseAbs().maxCoeff(), 0.02);
  plate.problem.along.clear();
  const auto over_plane = SolveDirectly(plate.problem, PlateEquations(plate.problem, true, 0));
  EXPECT_GT((*over_plane - *direct).cwiseAbs().maxCoeff(), 0.05);
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

TEST(SolveInTwoLevelsTest, IsAsExactInEveryUnit) {
  Plate plate = MakePlate(RoughHills, Everywhere, Nowhere, kLarge);
  for (Point3& p : plate.problem.points) p *= 1e-4;
  const PlateEquations equations(plate.problem, true, 0);
  const auto heights = SolveInTwoLevels(plate.problem, equations), direct = SolveDirectly(plate.problem, equations);
  ASSERT_TRUE(heights.has_value() && direct.has_value());
  const PointValues error = *heights - *direct;
  EXPECT_LT(std::sqrt(error.dot(equations.Apply(error)) / equations.Energy(*direct)), 2 * kLeastError);
}

TEST(SolveInTwoLevelsTest, GoesPastUprightWallsAlongTheRim) {
  Plate plate = MakePlate(RoughHills, Everywhere, Nowhere, kLarge);
  for (Point3& p : plate.problem.points) {
    if (p.head<2>().cwiseAbs().maxCoeff() <= kLarge) continue;
    p = {std::clamp<double>(p.x(), -kLarge, kLarge), std::clamp<double>(p.y(), -kLarge, kLarge), p.z() - 5};
  }
  FreeSteepRim(plate.problem);
  const PlateEquations equations(plate.problem, true, 0);
  const auto heights = SolveInTwoLevels(plate.problem, equations), direct = SolveDirectly(plate.problem, equations);
  ASSERT_TRUE(heights.has_value() && direct.has_value());
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

TEST(SolveThinPlateTest, EndsSoonWhereverItIsCancelled) {
  const Plate plate = MakePlate(RoughHills, Everywhere, Nowhere, kLarge);
  int asked = 0, end = std::numeric_limits<int>::max();
  const auto solve = [&](ThinPlateProblem problem) {
    asked = 0;
    problem.is_cancelled = [&] { return ++asked >= end; };
    const bool is_solved = SolveThinPlate(problem).has_value();
    EXPECT_EQ(problem.points != plate.problem.points, is_solved);
    return is_solved;
  };
  ASSERT_TRUE(solve(plate.problem));
  const int all = asked;
  for (const int at : {1, all / 2, all}) {
    end = at;
    EXPECT_FALSE(solve(plate.problem)) << at;
    EXPECT_LE(asked, at + 1);
  }
}

}  // namespace
}  // namespace tilemend
