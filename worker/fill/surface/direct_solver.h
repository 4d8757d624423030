// Solves the equations of a thin plate by a factorisation.
#ifndef TILEMEND_WORKER_FILL_SURFACE_DIRECT_SOLVER_H_
#define TILEMEND_WORKER_FILL_SURFACE_DIRECT_SOLVER_H_

#include <Eigen/SparseCholesky>
#include <optional>

#include "worker/fill/surface/plate_equations.h"

namespace tilemend {

// A sparse Cholesky factorisation of a symmetric matrix, of which `lower` is the lower triangle, in an order of
// approximate minimum degree (Eigen). Its memory is that of the triangle and of the factor: Eigen's own way to the
// order would have whole copies of the matrix beside them.
class SymmetricFactorization {
 public:
  explicit SymmetricFactorization(Eigen::SparseMatrix<double> lower);
  bool ok() const { return solver_.info() == Eigen::Success; }
  Eigen::VectorXd Solve(const Eigen::VectorXd& right_side) const;

 private:
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> back_;  // from the order to the numbers of the matrix
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>> solver_;
};

// The same of A. About O(n^1.5) for n unknown points at even distances; close to O(n) on graded meshes, whose
// separators are small.
class PlateFactorization {
 public:
  // `equations` must outlive it.
  explicit PlateFactorization(const PlateEquations& equations);
  bool ok() const { return factorization_.ok(); }
  // A^-1 of a residual.
  PointValues Solve(const PointValues& residual) const;

 private:
  const PlateEquations& equations_;
  const SymmetricFactorization factorization_;
};

// The heights of the points that have one; zero elsewhere.
PointValues GivenHeights(const ThinPlateProblem& problem);

// The heights of all points, or nothing if the factorisation fails.
std::optional<PointValues> SolveDirectly(const ThinPlateProblem& problem, const PlateEquations& equations);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_DIRECT_SOLVER_H_
