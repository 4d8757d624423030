// The covariance of heights of a thin plate under tension on an unbounded plane.
#ifndef TILEMEND_WORKER_FILL_SURFACE_TENSION_KERNEL_H_
#define TILEMEND_WORKER_FILL_SURFACE_TENSION_KERNEL_H_

#include <Eigen/Core>
#include <vector>

namespace tilemend {

// The fundamental solution of Laplacian^2 - t Laplacian, at distance r in a unit of length, t in 1 / unit^2:
//   r^2 ln r / (8 pi)                             for t = 0,
//   -(ln r + K0(sqrt(t) r)) / (2 pi t)            for t > 0
// (Wahba 1990; Mitas and Mitasova 1988).
//   distances  above 0
Eigen::ArrayXd TensionKernel(const Eigen::ArrayXd& distances, double tension);

// Its limit at distance 0.
double TensionKernelAtZero(double tension);

// The same from a table, within 1e-10 / t where t > 0: some ten times as fast.
class TensionKernelTable {
 public:
  explicit TensionKernelTable(double tension);

  // At a distance of 0 or more. O(1).
  double At(double distance) const;

 private:
  double tension_;
  std::vector<double> values_;  // at even steps of sqrt(x), x = sqrt(t) r; the first at one step below 0
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_TENSION_KERNEL_H_
