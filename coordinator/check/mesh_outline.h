// Whether a mesh is closed.
#ifndef TILEMEND_COORDINATOR_CHECK_MESH_OUTLINE_H_
#define TILEMEND_COORDINATOR_CHECK_MESH_OUTLINE_H_

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Whether some edge, on welded positions, has exactly one triangle with three corners. O(n log n) in the triangles,
// some 100 bytes each: for the rare tile that is said to have no boundary at all.
bool HasBoundary(const TriMesh& mesh);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_CHECK_MESH_OUTLINE_H_
