// Refines a patch where it is curved.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_CURVATURE_PATCH_H_
#define TILEMEND_WORKER_PAPERS_FRONT_CURVATURE_PATCH_H_

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/filler.h"

namespace tilemend {

// Points of a patch, the rim's first, and the triangles of the surface at the rim over these and `around`. Points of
// `around` are numbered after those of the patch once it is done.
struct CurvaturePatch {
  std::vector<Point3> points;
  int32_t rim = 0;
  std::vector<Triangle> triangles;
};

struct RimSurface {
  std::vector<Point3> points;  // those of the rim first
  std::vector<Triangle> triangles;
};

// Gaussian curvature of the first `count` points: the angle that is missing of a full turn, over the mixed area of
// Meyer et al. 2003. Absolute values, 1 / metre^2.
std::vector<double> AbsoluteCurvatures(std::span<const Point3> points, std::span<const Triangle> triangles,
                                       size_t count);

// The refinement and adjustment of the hole repair by curvature (section 4). The curvature of an edge is the mean of
// |Gaussian curvature| at its ends. Edges inside the patch above the rim's mean get a point in their middle. This goes
// on until none is above it or each has been halved options.halvings times. Edges are turned until no triangle has a
// point of its neighbour in its circumcircle. Then each new point goes options.centroid_steps times to the mean of its
// neighbours, weighted by the area around them: towards those that stand further apart.
//   may_join  whether an edge may run between two points of the rim
// Left as it is if the triangles form no manifold. Linear for each step.
void RefineByCurvature(const RimSurface& surface, const FillerOptions& options,
                       const std::function<bool(int32_t, int32_t)>& may_join, CurvaturePatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_CURVATURE_PATCH_H_
