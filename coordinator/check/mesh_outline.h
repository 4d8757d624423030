// The outline of a mesh on welded positions.
#ifndef TILEMEND_COORDINATOR_CHECK_MESH_OUTLINE_H_
#define TILEMEND_COORDINATOR_CHECK_MESH_OUTLINE_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// An edge by the lowest vertices at its ends' positions, the lower one first.
using OutlineEdge = std::pair<int32_t, int32_t>;

// The edges that exactly one triangle with corners at three positions has, sorted. Copies count as one. O(n log n) in
// the triangles, some 100 bytes each: for the rare tile of which something seems to be wrong.
std::vector<OutlineEdge> OutlineOf(const TriMesh& mesh);

// A sum over all edges that have an odd number of triangles; OutlineSumOfEdge gives the summand of one edge. If the
// sums of a mesh and of edges differ, these edges are not its outline. If they are equal, they are it when no edge has
// three triangles, but for one case in 2^64, as long as nobody knows `key`. Linear, without memory to speak of.
struct OutlineSum {
  uint64_t sum = 0;
  int64_t flat_triangles = 0;  // with two corners at one position; left out
};
OutlineSum OutlineSumOf(const TriMesh& mesh, uint64_t key);
uint64_t OutlineSumOfEdge(const Point3& a, const Point3& b, uint64_t key);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_CHECK_MESH_OUTLINE_H_
