// The surface around a hole, ring by ring.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_SURFACE_RINGS_H_
#define TILEMEND_WORKER_PAPERS_FRONT_SURFACE_RINGS_H_

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/filler.h"

namespace tilemend {

// A vertex and its Laplacian: half the sum of eq. 3's weights times the edges to its neighbours (Xu 2014, eq. 1). It is
// divided by the sum of these halved weights (eq. 2) or by its Voronoi area (eq. 4, but for the sign).
struct LaplacianSample {
  Point3 at;
  Eigen::Vector3d laplacian;
};

// The vertices of the first `rings` rings around a rim (Xu 2014, 3.3), in the order of the surface's triangles. Those
// that the triangles do not surround are left out, as are those of the rim itself: they have no Laplacian.
//   rim      places of its vertices, as the surface has them
//   surface  triangles; equal places are one vertex
//   scale    what the sum is divided by
// O(surface log surface).
std::vector<LaplacianSample> SampleRings(std::span<const Point3> rim, std::span<const SpaceTriangle> surface,
                                         int32_t rings, LaplacianScale scale = LaplacianScale::kMean);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_SURFACE_RINGS_H_
