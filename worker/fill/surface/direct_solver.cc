#include "worker/fill/surface/direct_solver.h"

#include <algorithm>
#include <numeric>
#include <span>
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

// Finds in which columns the rows of the factor have entries (Davis 2006, ereach).
class SymmetricFactorization::Solver::Rows {
 public:
  Rows(const Eigen::SparseMatrix<double>& upper, const Eigen::VectorXi& parent)
      : upper_(upper), parent_(parent), seen_by_(upper.cols(), -1), columns_(upper.cols()) {}

  // The columns of row `k` but the last, in an order in which they can be solved for; adds the matrix to `row`.
  std::span<const int> Take(int k, Eigen::VectorXd& row) {
    size_t first = columns_.size();
    seen_by_[k] = k;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(upper_, k); entry && entry.index() <= k; ++entry) {
      row[entry.index()] += entry.value();
      size_t count = 0;
      for (int i = static_cast<int>(entry.index()); seen_by_[i] != k; i = parent_[i]) {
        columns_[count++] = i;
        seen_by_[i] = k;
      }
      while (count > 0) columns_[--first] = columns_[--count];
    }
    return std::span(columns_).subspan(first);
  }

 private:
  const Eigen::SparseMatrix<double>& upper_;
  const Eigen::VectorXi& parent_;  // of the elimination tree
  std::vector<int> seen_by_;       // of each column: the last row that has it
  std::vector<int> columns_;
};

// The arithmetic is that of Eigen's factorize_preordered, in the same order.
void SymmetricFactorization::Solver::Factorize(const Eigen::SparseMatrix<double>& upper,
                                               const std::function<bool()>& is_cancelled) {
  is_begun_ = true;
  analyzePattern(upper);
  const auto size = static_cast<int>(upper.cols());
  const int* const begin = m_matrix.outerIndexPtr();
  int* const rows = m_matrix.innerIndexPtr();
  double* const factor = m_matrix.valuePtr();
  Rows pattern(upper, m_parent);
  Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
  m_diag.resize(size);
  m_info = Eigen::NumericalIssue;
  m_factorizationIsOk = true;
  for (int k = 0; k < size; ++k) {
    if (is_cancelled && is_cancelled()) return;
    m_nonZerosPerCol[k] = 0;
    const std::span<const int> columns = pattern.Take(k, row);
    double diagonal = std::exchange(row[k], 0);
    for (const int i : columns) {
      const double above = std::exchange(row[i], 0), entry = above / m_diag[i];
      const int end = begin[i] + m_nonZerosPerCol[i]++;
      for (int p = begin[i]; p < end; ++p) row[rows[p]] -= factor[p] * above;
      diagonal -= entry * above;
      rows[end] = k;
      factor[end] = entry;
    }
    m_diag[k] = diagonal;
    if (diagonal == 0) return;
  }
  m_info = Eigen::Success;
}

SymmetricFactorization::SymmetricFactorization(Eigen::SparseMatrix<double> lower,
                                               const std::function<bool()>& is_cancelled) {
  if (is_cancelled && is_cancelled()) return;
  back_ = OrderOf(lower);
  Factorize(std::move(lower), is_cancelled);
}

SymmetricFactorization::SymmetricFactorization(EliminationOrder order, Eigen::SparseMatrix<double> lower,
                                               const std::function<bool()>& is_cancelled)
    : back_(std::move(order)) {
  Factorize(std::move(lower), is_cancelled);
}

void SymmetricFactorization::Factorize(Eigen::SparseMatrix<double> lower, const std::function<bool()>& is_cancelled) {
  Eigen::SparseMatrix<double> ordered(lower.rows(), lower.cols());
  ordered.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(back_.inverse());
  lower = Eigen::SparseMatrix<double>();
  lower.data().squeeze();
  solver_.Factorize(ordered, is_cancelled);
}

Eigen::VectorXd SymmetricFactorization::Solve(const Eigen::VectorXd& right_side) const {
  return back_ * solver_.solve(back_.inverse() * right_side);
}

Eigen::MatrixXd SymmetricFactorization::Solve(const Eigen::MatrixXd& right_sides) const {
  return back_ * solver_.solve(back_.inverse() * right_sides);
}

PlateFactorization::PlateFactorization(const PlateEquations& equations, const std::function<bool()>& is_cancelled)
    : equations_(equations), factorization_(equations.LowerMatrix(), is_cancelled) {}

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
  const PlateFactorization factorization(equations, problem.is_cancelled);
  if (!factorization.ok()) return std::nullopt;
  PointValues heights = GivenHeights(problem);
  heights += factorization.Solve(equations.Residual(heights));
  if (!heights.allFinite()) return std::nullopt;
  return heights;
}

}  // namespace tilemend
