// A coarser mesh for a thin-plate problem, and the way between the two.
#ifndef TILEMEND_WORKER_FILL_SURFACE_COARSE_PLATE_H_
#define TILEMEND_WORKER_FILL_SURFACE_COARSE_PLATE_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "worker/fill/surface/plate_equations.h"

namespace tilemend {

// Takes heights (or corrections) from a coarse mesh to the points of a finer one. Around every coarse point stands the
// quadratic that fits the coarse heights there best. A fine point gets the mean of the quadratics around it. The
// weights fall to zero smoothly: a partition of unity (Babuska & Melenk 1997). Linear functions are kept exactly,
// quadratics nearly: what the energy of a plate needs.
//
// The fine problem must outlive it.
class PlateInterpolation {
 public:
  explicit PlateInterpolation(const ThinPlateProblem& fine) : fine_(&fine) {}

  // The values at the unknown fine points; zero elsewhere.
  PointValues ToFine(const PointValues& coarse) const;
  // The transpose.
  PointValues ToCoarse(const PointValues& fine) const;

 private:
  friend class PlateCoarsener;
  using Terms = Eigen::Matrix<double, 5, 1>;
  using StoredTerms = Eigen::Matrix<float, 5, 1>;

  // A coarse point and the quadratic z + f . (x, y, x^2, x y, y^2), with x and y from the point in units of `size`.
  struct Patch {
    Point2 centre;
    double inverse_size;
    int32_t first_neighbor;  // into neighbor_ and fit_
    int32_t first_target;    // into target_
  };
  Point2 Place(const Patch& patch, int32_t fine) const;

  const ThinPlateProblem* fine_;
  int32_t coarse_count_ = 0;
  std::vector<Patch> patches_;        // the first coarse points, and one more as an end
  std::vector<int32_t> neighbor_;     // coarse points
  std::vector<StoredTerms> fit_;      // how f depends on the neighbour's height over the point's
  std::vector<int32_t> target_;       // unknown fine points
  std::vector<float> inverse_total_;  // per fine point: one over the sum of its weights
};

struct CoarsePlate {
  ThinPlateProblem problem;
  PlateInterpolation interpolation;
};

// Leaves out points of `problem` inside the patch, and triangulates the rest. It leaves out more of them the farther
// they are from the patch's boundary and from points of known height. One to two coarse unknowns are left for each
// point of the boundary. Linear in the points but for the triangulation (region_triangulation.h). Nothing if the
// boundary of the patch bounds no region on a lattice of its own. Deterministic.
std::optional<CoarsePlate> CoarsenPlate(const ThinPlateProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_COARSE_PLATE_H_
