// The equations of the thin-plate surface of a patch, without a solver.
#ifndef TILEMEND_WORKER_FILL_SURFACE_PLATE_EQUATIONS_H_
#define TILEMEND_WORKER_FILL_SURFACE_PLATE_EQUATIONS_H_

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <utility>
#include <vector>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// A value for each point of the problem.
using PointValues = Eigen::VectorXd;

// The symmetric positive definite system A h = b for the unknown heights h of a patch, A = K M^-1 K + tension K. The
// matrices are the cotangent matrix K of linear finite elements and lumped masses M (see thin_plate.h). Only K is
// stored, a row for each point of patch and band that needs one: 12 bytes for each pair of joined points.
//
// Vectors have a value for each point; those of corrections and residuals are zero at points of known height.
class PlateEquations {
 public:
  // Without `bends`, A = tension K: the membrane. Linear in the triangles.
  PlateEquations(const ThinPlateProblem& problem, bool bends, double tension);

  int32_t unknown_count() const { return static_cast<int32_t>(unknown_.size()); }

  // M^-1 K h at points with an equation of their own; elsewhere what is known of the Laplacian, or zero. `heights`
  // counts known points.
  PointValues Laplacians(const PointValues& heights) const;
  // b - A h.
  PointValues Residual(const PointValues& heights) const;
  // A x for a correction x.
  PointValues Apply(const PointValues& x) const;
  // The diagonal of A; one at known points.
  PointValues Diagonal() const;
  // The integral of |Laplacian|^2 + tension |gradient|^2; of edges between known and unknown points, half.
  double Energy(const PointValues& heights) const;

  // The lower half of A over the unknown points in order; see Gather.
  Eigen::SparseMatrix<double> LowerMatrix() const;
  Eigen::VectorXd Gather(const PointValues& values) const;        // those of the unknown points
  PointValues Spread(const Eigen::VectorXd& unknown_only) const;  // the way back

 private:
  void StoreRow(int32_t v, const std::vector<std::pair<int32_t, double>>& row);
  double Row(int32_t v, const PointValues& x) const;
  // use(point, weight) for the entries of row v in the order of points, v itself among them.
  template <class Use>
  void EachInRow(int32_t v, const Use& use) const {
    int32_t i = start_[v];
    for (; i < start_[v + 1] && to_[i] < v; ++i) use(to_[i], weight_[i]);
    use(v, diagonal_[v]);
    for (; i < start_[v + 1]; ++i) use(to_[i], weight_[i]);
  }
  PointValues Product(const PointValues& x, const PointValues& laplacians) const;

  std::vector<int32_t> unknown_, column_;  // column_: place in unknown_, or -1
  std::vector<int32_t> start_, to_;        // per point: the points that it is joined with, in order
  std::vector<double> weight_;             // half the sum of the cotangents at the edge
  Eigen::VectorXd diagonal_;               // minus the sum of a row's weights
  Eigen::VectorXd inverse_mass_;           // zero at points without an equation
  Eigen::VectorXd given_;                  // known Laplacians of such points
  double tension_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_PLATE_EQUATIONS_H_
