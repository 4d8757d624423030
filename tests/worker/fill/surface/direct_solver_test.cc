#include "worker/fill/surface/direct_solver.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "tests/worker/fill/surface/plates.h"

namespace tilemend {
namespace {

using testing::Everywhere;
using testing::Hills;
using testing::MakePlate;
using testing::Noise;
using testing::Nowhere;
using testing::Plate;

TEST(PlateFactorizationTest, IsTheInverseOfTheOperator) {
  for (const double tension : {0.0, 0.3}) {
    const Plate plate = MakePlate(Hills, Everywhere, Nowhere);
    const PlateEquations equations(plate.problem, true, tension);
    const PlateFactorization factorization(equations);
    ASSERT_TRUE(factorization.ok());
    const PointValues x = Noise(plate.problem, false);
    EXPECT_LT((factorization.Solve(equations.Apply(x)) - x).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST(GivenHeightsTest, AreZeroWhereNoneIsKnown) {
  const Plate plate = MakePlate([](double, double) { return 3.0; }, Everywhere, Nowhere);
  const PointValues heights = GivenHeights(plate.problem);
  for (Eigen::Index v = 0; v < heights.size(); ++v) EXPECT_EQ(heights[v], plate.problem.known[v] ? 3 : 0);
}

TEST(SolveDirectlyTest, LeavesNoResidual) {
  const Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  const PlateEquations equations(plate.problem, true, 0.01);
  const std::optional<PointValues> heights = SolveDirectly(plate.problem, equations);
  ASSERT_TRUE(heights.has_value());
  EXPECT_LT(equations.Residual(*heights).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SolveDirectlyTest, IsNothingForHeightsThatAreNoNumbers) {
  Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  plate.problem.points[plate.at.at({testing::kHalf, 0})].z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(SolveDirectly(plate.problem, PlateEquations(plate.problem, true, 0)).has_value());
}

}  // namespace
}  // namespace tilemend
