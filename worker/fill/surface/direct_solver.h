// Solves the equations of a thin plate by a factorisation.
#ifndef TILEMEND_WORKER_FILL_SURFACE_DIRECT_SOLVER_H_
#define TILEMEND_WORKER_FILL_SURFACE_DIRECT_SOLVER_H_

#include <Eigen/SparseCholesky>
#include <functional>
#include <optional>

#include "worker/fill/surface/plate_equations.h"

namespace tilemend {

// From the order in which unknowns are eliminated to their numbers in the matrix.
using EliminationOrder = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

// The order of approximate minimum degree (Eigen) of a symmetric matrix, of which `lower` is the lower triangle. It
// serves every matrix with entries at the same places.
EliminationOrder OrderOf(const Eigen::SparseMatrix<double>& lower);

// A sparse Cholesky factorisation of a symmetric matrix, of which `lower` is the lower triangle. Its memory is that of
// the triangle and of the factor. Eigen's own way to the order would have whole copies of the matrix beside them.
//   is_cancelled  asked before it is ordered and for each column, since a factorisation may take minutes; true ends
//                 it, and it is not ok
class SymmetricFactorization {
 public:
  explicit SymmetricFactorization(Eigen::SparseMatrix<double> lower, const std::function<bool()>& is_cancelled = {});
  SymmetricFactorization(EliminationOrder order, Eigen::SparseMatrix<double> lower,
                         const std::function<bool()>& is_cancelled = {});
  bool ok() const { return solver_.ok(); }
  Eigen::VectorXd Solve(const Eigen::VectorXd& right_side) const;
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& right_sides) const;  // each column

 private:
  using Ldlt = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>>;

  // Eigen's, whose own factorisation cannot be ended.
  class Solver : public Ldlt {
   public:
    // As compute(upper), unless it is cancelled.
    void Factorize(const Eigen::SparseMatrix<double>& upper, const std::function<bool()>& is_cancelled);
    bool ok() const { return is_begun_ && info() == Eigen::Success; }

   private:
    class Rows;

    bool is_begun_ = false;
  };

  void Factorize(Eigen::SparseMatrix<double> lower, const std::function<bool()>& is_cancelled);

  EliminationOrder back_;
  Solver solver_;
};

// The same of A. About O(n^1.5) for n unknown points at even distances; close to O(n) on graded meshes, whose
// separators are small.
class PlateFactorization {
 public:
  // `equations` must outlive it. `is_cancelled` as of SymmetricFactorization.
  explicit PlateFactorization(const PlateEquations& equations, const std::function<bool()>& is_cancelled = {});
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
