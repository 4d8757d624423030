// Moves the new points of a refined region to even out its triangles.
#ifndef TILEMEND_WORKER_FILL_REGION_SMOOTH_REGION_H_
#define TILEMEND_WORKER_FILL_REGION_SMOOTH_REGION_H_

#include <cstddef>
#include <span>

#include "common/mesh/triangulation/delaunay.h"

namespace tilemend::internal {

// Moves the points from index `first_movable` on, one after the other, in two kinds of rounds. After each round it
// flips edges until the mesh is constrained Delaunay again.
//   even_rounds   each point towards the weighted mean of the circumcentres around it (optimal Delaunay triangulation:
//                 Chen 2004, Alliez et al. 2005), which evens out sizes
//   shape_rounds  each point uphill in the sum of the shapes (4 sqrt(3) area / sum of squared edges) of the triangles
//                 around it; a move is taken only if the sum grows
//   size          wanted edge length per point
// A move is taken only if the triangles around the point stay counter-clockwise (exact). The worst of them may get
// worse only if it keeps a good shape. Clears the flags of all triangles. Precondition: every movable point lies inside
// the region, not on a wall. Cost: linear in the points per round; deterministic.
void SmoothRegion(DelaunayMesh& mesh, size_t first_movable, std::span<const double> size, int even_rounds,
                  int shape_rounds);

}  // namespace tilemend::internal

#endif  // TILEMEND_WORKER_FILL_REGION_SMOOTH_REGION_H_
