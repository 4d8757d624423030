// What a thin plate under tension foretells of heights from others.
#ifndef TILEMEND_WORKER_FILL_SURFACE_KRIGING_H_
#define TILEMEND_WORKER_FILL_SURFACE_KRIGING_H_

#include <Eigen/Core>
#include <Eigen/QR>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/surface/tension_kernel.h"

namespace tilemend {

// The samples of a division, in blocks.
using SampleBlocks = std::vector<std::vector<int>>;

// Heights foretold at other places.
class HeightTrend {
 public:
  // In metres; at a sample whose height has no variance of its own, that height. O(n).
  double At(const Point2& place) const;

 private:
  friend class Kriging;
  explicit HeightTrend(double tension) : kernel_(tension) {}

  Point3 origin_;
  double width_ = 1;  // metres
  TensionKernelTable kernel_;
  std::vector<Point2> places_;                       // of the samples
  Eigen::VectorXd weights_;                          // of the samples
  Eigen::Vector3d drift_ = Eigen::Vector3d::Zero();  // constant, and slopes times width
};

// Kriging of heights with a linear drift and, as covariance, the kernel of a plate under tension (tension_kernel.h).
// O(n^3) for n samples, O(n^2) memory.
class Kriging {
 public:
  //   samples  no two above each other; more than three
  //   width    the unit of length, metres
  //   tension  t, in 1 / width^2
  //   drift    what all heights have in common: a plane, or (tension > 0) only a constant
  enum class Drift { kConstant = 1, kLinear = 3 };
  Kriging(const std::vector<Point3>& samples, double width, double tension, Drift drift = Drift::kLinear);

  // The likeliest heights elsewhere.
  //   noise  variance of each height by itself, over the kernel's scale: draws them away from the samples to the drift
  HeightTrend Trend(double noise) const;

  // The mean |error| of each block of each division, when it is left out. With C the inverse of the kriging matrix it
  // is (C_BB)^-1 (C z)_B, without a further solve (Dubrule 1983).
  std::vector<Eigen::VectorXd> BlockErrors(const std::vector<SampleBlocks>& divisions) const;

 private:
  Eigen::MatrixXd Inverse() const;

  const std::vector<Point3> samples_;
  const double width_, tension_;
  const Eigen::Index drift_terms_;
  // The covariances after reflections that take the drift to the first coordinates: positive definite in the others
  // (Wahba 1990, 2.4).
  Eigen::MatrixXd matrix_;
  Eigen::HouseholderQR<Eigen::MatrixXd> reflections_;
  Eigen::VectorXd heights_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_KRIGING_H_
