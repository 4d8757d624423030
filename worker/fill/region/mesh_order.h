// Renumbers a refined mesh so that what lies near each other in the plane lies near each other in memory.
#ifndef TILEMEND_WORKER_FILL_REGION_MESH_ORDER_H_
#define TILEMEND_WORKER_FILL_REGION_MESH_ORDER_H_

#include <cstddef>
#include <vector>

#include "common/mesh/triangulation/delaunay.h"

namespace tilemend::internal {

// Sorts the points from index `first` on along a Hilbert curve, with their sizes, and the triangles by their lowest
// point. Refinement goes round the rim, one layer after the other. That order would cost later steps a fourth to a
// third of their time in cache misses. O(n log n); deterministic. Triangles at walls stay with their segments.
//   size  per point
void SortMesh(DelaunayMesh& mesh, size_t first, std::vector<double>& size);

}  // namespace tilemend::internal

#endif  // TILEMEND_WORKER_FILL_REGION_MESH_ORDER_H_
