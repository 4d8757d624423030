// Shapes a patch by Laplacians learnt from the surface around it.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_SVM_PATCH_H_
#define TILEMEND_WORKER_PAPERS_FRONT_SVM_PATCH_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/filler.h"
#include "worker/papers/front/surface_rings.h"

namespace tilemend {

// By Xu 2014, 3.4, a regression for each axis from the coordinate to the Laplacian's component (eq. 9 to 15, both
// numbers, as printed). It gives the Laplacians of the new points where the front put them (eq. 19). Then come the
// points that have these, with the rim as Dirichlet boundary (eq. 18). Without samples the Laplacians are zero. Of more
// than 2000 samples every second, third, ... is taken.
//   edge    mean of the rim, metres
//   points  those of the rim, `rim` of them, first
// False, with the points as they were, if there is no solution.
bool ShapeByLaplacians(std::span<const LaplacianSample> samples, const FillerOptions& options, double edge,
                       std::span<const Triangle> triangles, int32_t rim, std::vector<Point3>& points);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_SVM_PATCH_H_
