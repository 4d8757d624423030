#include "worker/fill/surface/direct_solver.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace tilemend {

namespace {

// Where a symmetric matrix has entries, with room for what the ordering puts there.
Eigen::SparseMatrix<char> PatternOf(const Eigen::SparseMatrix<double>& lower) {
  std::vector<int> in_column(static_cast<size_t>(lower.cols()), 0);
  const auto for_entries = [&](const auto& use) {
    for (int column = 0; column < lower.cols(); ++column) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, column); entry; ++entry) {
        use(column, static_cast<int>(entry.row()));
        if (entry.row() != column) use(static_cast<int>(entry.row()), column);
      }
    }
  };
  for_entries([&](int column, int) { ++in_column[column]; });
  Eigen::SparseMatrix<char> pattern(lower.rows(), lower.cols());
  int* const begin = pattern.outerIndexPtr();
  std::partial_sum(in_column.begin(), in_column.end(), begin + 1);
  const Eigen::Index entries = begin[lower.cols()];
  pattern.reserve(entries + entries / 5 + 2 * lower.cols());
  pattern.resizeNonZeros(entries);
  std::copy_n(begin, lower.cols(), in_column.begin());  // where the next entry goes
  for_entries([&](int column, int row) { pattern.innerIndexPtr()[in_column[column]++] = row; });
  return pattern;
}

}  // namespace

EliminationOrder OrderOf(const Eigen::SparseMatrix<double>& lower) {
  Eigen::SparseMatrix<char> pattern = PatternOf(lower);
  EliminationOrder order;
  Eigen::internal::minimum_degree_ordering(pattern, order);
  return order;
}

SymmetricFactorization::SymmetricFactorization(Eigen::SparseMatrix<double> lower)
    : SymmetricFactorization{OrderOf(lower), lower} {}

SymmetricFactorization::SymmetricFactorization(EliminationOrder order, Eigen::SparseMatrix<double> lower)
    : back_(std::move(order)) {
  Eigen::SparseMatrix<double> ordered(lower.rows(), lower.cols());
  ordered.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(back_.inverse());
  lower = Eigen::SparseMatrix<double>();
  lower.data().squeeze();
  solver_.compute(ordered);
}

Eigen::VectorXd SymmetricFactorization::Solve(const Eigen::VectorXd& right_side) const {
  return back_ * solver_.solve(back_.inverse() * right_side);
}

Eigen::MatrixXd SymmetricFactorization::Solve(const Eigen::MatrixXd& right_sides) const {
  return back_ * solver_.solve(back_.inverse() * right_sides);
}

PlateFactorization::PlateFactorization(const PlateEquations& equations)
    : equations_(equations), factorization_(equations.LowerMatrix()) {}

PointValues PlateFactorization::Solve(const PointValues& residual) const {
  return equations_.Spread(factorization_.Solve(equations_.Gather(residual)));
}

PointValues GivenHeights(const ThinPlateProblem& problem) {
  PointValues heights(static_cast<Eigen::Index>(problem.points.size()));
  for (size_t v = 0; v < problem.points.size(); ++v) {
    heights[static_cast<Eigen::Index>(v)] = problem.known[v] ? problem.points[v].z() : 0;
  }
  return heights;
}

std::optional<PointValues> SolveDirectly(const ThinPlateProblem& problem, const PlateEquations& equations) {
  const PlateFactorization factorization(equations);
  if (!factorization.ok()) return std::nullopt;
  PointValues heights = GivenHeights(problem);
  heights += factorization.Solve(equations.Residual(heights));
  if (!heights.allFinite()) return std::nullopt;
  return heights;
}

}  // namespace tilemend
