// Shapes a triangulated patch: adjustment and second-order fairing of its heights.
#ifndef TILEMEND_WORKER_FILL_SURFACE_FAIR_HEIGHTS_H_
#define TILEMEND_WORKER_FILL_SURFACE_FAIR_HEIGHTS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A patch in a frame in which it projects: x, y in the plane, z the height.
struct FairingProblem {
  // Rim vertices first (fixed), then the new ones, then further band vertices (fixed).
  std::vector<Point3> points;
  int32_t rim_count = 0;
  int32_t new_count = 0;
  std::vector<Triangle> patch;  // over rim and new vertices
  std::vector<Triangle> band;   // original triangles at the rim: give the tangent there; may be empty
  // Rim vertices whose whole ring is known: patch and band together surround them. Others (on seams) bend freely.
  std::vector<bool> has_equation;
};

// Gives every new vertex the inverse-distance-weighted mean height of the first and second neighbours that have one,
// ring by ring from the rim inward (Wang 2021, eq. 1). Fills points[rim_count .. rim_count + new_count).z.
void AdjustHeights(FairingProblem& problem);

// Solves U^2(v) = 0 for all new vertices, with the second-order weighted umbrella operator (Wang 2021, eq. 2 and 4) and
// cotangent weights (eq. 3) in the plane: L D^-1 L h = 0, where a rim vertex that patch and band surround has an
// equation of its own, so that the patch goes on with the slope of the band. Sparse Cholesky (Eigen); O(n^1.5). Returns
// false, with the heights as they were, if the factorisation fails.
bool FairHeights(FairingProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_FAIR_HEIGHTS_H_
