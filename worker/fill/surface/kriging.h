// What a thin plate under tension foretells of heights from others.
#ifndef TILEMEND_WORKER_FILL_SURFACE_KRIGING_H_
#define TILEMEND_WORKER_FILL_SURFACE_KRIGING_H_

#include <Eigen/Core>
#include <Eigen/QR>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The samples of a division, in blocks.
using SampleBlocks = std::vector<std::vector<int>>;

// Kriging of heights with a linear drift and, as covariance, the fundamental solution of Laplacian^2 - t Laplacian on
// an unbounded plane:
//   r^2 ln r / (8 pi)                             for t = 0,
//   -(ln r + K0(sqrt(t) r)) / (2 pi t)            for t > 0
// (Wahba 1990; Mitas and Mitasova 1988). O(n^3) for n samples, O(n^2) memory.
class Kriging {
 public:
  //   samples  no two above each other; more than three
  //   width    the unit of length, metres
  //   tension  t, in 1 / width^2
  Kriging(const std::vector<Point3>& samples, double width, double tension);

  // The restricted log-likelihood (Patterson and Thompson 1971): of the heights but for what the drift explains, and
  // but for a constant; with the scale of heights that suits them best.
  //   noise  variance of each height by itself, over that scale
  double LogLikelihood(double noise) const;

  // The mean |error| of each block of each division, when it is left out: (C_BB)^-1 (C z)_B with C the inverse of the
  // kriging matrix, without a further solve (Dubrule 1983).
  std::vector<Eigen::VectorXd> BlockErrors(const std::vector<SampleBlocks>& divisions) const;

 private:
  static constexpr Eigen::Index kDrift = 3;  // linear

  Eigen::MatrixXd Inverse() const;

  // The covariances after reflections that take the drift to the first coordinates: positive definite in the others
  // (Wahba 1990, 2.4).
  Eigen::MatrixXd matrix_;
  Eigen::HouseholderQR<Eigen::MatrixXd> reflections_;
  Eigen::VectorXd heights_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_KRIGING_H_
