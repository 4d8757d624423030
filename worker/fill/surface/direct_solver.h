// Solves the equations of a thin plate by a factorisation.
#ifndef TILEMEND_WORKER_FILL_SURFACE_DIRECT_SOLVER_H_
#define TILEMEND_WORKER_FILL_SURFACE_DIRECT_SOLVER_H_

#include <Eigen/SparseCholesky>
#include <optional>

#include "worker/fill/surface/plate_equations.h"

namespace tilemend {

// Approximate minimum degree on a matrix that is symmetric: Eigen's own adds its transpose to it first.
struct SymmetricOrdering {
  using PermutationType = Eigen::AMDOrdering<int>::PermutationType;
  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) const {
    Eigen::AMDOrdering<int>()(matrix.template selfadjointView<Eigen::Lower>(), permutation);
  }
};

// A sparse Cholesky factorisation of A (Eigen). About O(n^1.5) for n unknown points at even distances; close to O(n) on
// graded meshes, whose separators are small.
class PlateFactorization {
 public:
  // `equations` must outlive it.
  explicit PlateFactorization(const PlateEquations& equations);
  bool ok() const { return solver_.info() == Eigen::Success; }
  // A^-1 of a residual.
  PointValues Solve(const PointValues& residual) const;

 private:
  const PlateEquations& equations_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, SymmetricOrdering> solver_;
};

// The heights of the points that have one; zero elsewhere.
PointValues GivenHeights(const ThinPlateProblem& problem);

// The heights of all points, or nothing if the factorisation fails.
std::optional<PointValues> SolveDirectly(const ThinPlateProblem& problem, const PlateEquations& equations);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_DIRECT_SOLVER_H_
