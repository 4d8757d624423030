// Moves the new points of a refined region to even out its triangles.
#ifndef TILEMEND_WORKER_FILL_INTERNAL_SMOOTHING_H_
#define TILEMEND_WORKER_FILL_INTERNAL_SMOOTHING_H_

#include <cstddef>
#include <span>

#include "common/mesh/internal_delaunay.h"

namespace tilemend::internal {

// Moves each point from index `first_movable` on towards the weighted mean of the circumcentres around it (optimal
// Delaunay triangulation: Chen 2004, Alliez et al. 2005), `rounds` times; after each round flips edges until the mesh
// is constrained Delaunay again. A move is taken only if the triangles around the point stay counter-clockwise and the
// worst of them does not get worse than it is or than a good shape; the check of orientation is exact. Clears the flags
// of all triangles. Precondition: every movable point lies inside the region, not on a wall.
//   size  wanted edge length per point
void SmoothRegion(DelaunayMesh& mesh, size_t first_movable, std::span<const double> size, int rounds);

}  // namespace tilemend::internal

#endif  // TILEMEND_WORKER_FILL_INTERNAL_SMOOTHING_H_
