#include "worker/fill/surface/direct_solver.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "tests/worker/fill/surface/plates.h"

namespace tilemend {
namespace {

using testing::Everywhere;
using testing::Hills;
using testing::MakePlate;
using testing::Noise;
using testing::Nowhere;
using testing::Plate;

using Matrix = Eigen::SparseMatrix<double>;

// The lower triangle of a grid of 6 x 6 with `diagonal`.
Matrix Grid(double diagonal) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < 36; ++i) {
    entries.emplace_back(i, i, diagonal);
    if (i % 6 < 5) entries.emplace_back(i + 1, i, -1);
    if (i < 30) entries.emplace_back(i + 6, i, -1);
  }
  Matrix lower(36, 36);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

TEST(SymmetricFactorizationTest, SolvesForEachColumnAsAlone) {
  const SymmetricFactorization factorization(Grid(5));
  const Eigen::MatrixXd right = Eigen::MatrixXd::Random(36, 3);
  const Eigen::MatrixXd all = factorization.Solve(right);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(all.col(k), factorization.Solve(Eigen::VectorXd(right.col(k))));
  const Eigen::MatrixXd back = Matrix(Grid(5).selfadjointView<Eigen::Lower>()) * all;
  EXPECT_LT((back - right).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SymmetricFactorizationTest, AnOrderServesAllMatricesWithTheSamePlaces) {
  const EliminationOrder order = OrderOf(Grid(5));
  const Eigen::VectorXd right = Eigen::VectorXd::Ones(36);
  EXPECT_EQ(SymmetricFactorization(order, Grid(7)).Solve(right), SymmetricFactorization(Grid(7)).Solve(right));
}

TEST(SymmetricFactorizationTest, HasTheBitsOfEigens) {
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(36, -1, 3);
  const EliminationOrder order = OrderOf(Grid(4.5));
  Matrix ordered(36, 36);
  ordered.selfadjointView<Eigen::Upper>() =
      Grid(4.5).selfadjointView<Eigen::Lower>().twistedBy(EliminationOrder(order.inverse()));
  const Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> eigens(ordered);
  const Eigen::VectorXd expected = order * eigens.solve(order.inverse() * right);
  EXPECT_EQ(SymmetricFactorization(Grid(4.5)).Solve(right), expected);
}

TEST(SymmetricFactorizationTest, EndsAtOnceWhenItIsCancelled) {
  int asked = 0;
  EXPECT_FALSE(SymmetricFactorization(Grid(5), [&] { return ++asked == 20; }).ok());
  EXPECT_EQ(asked, 20);
}

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
