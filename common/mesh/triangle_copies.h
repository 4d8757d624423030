// Triangles that a mesh has more than once.
#ifndef TILEMEND_COMMON_MESH_TRIANGLE_COPIES_H_
#define TILEMEND_COMMON_MESH_TRIANGLE_COPIES_H_

#include <optional>
#include <vector>

#include "common/mesh/mesh_view.h"

namespace tilemend {

// The triangles of a mesh, each once: of those with the same vertices in the same order around, the first. A back is no
// copy of its front, and triangles with vertices of their own are none, since they are of other pieces. Nothing if
// there are no copies. O(n log n).
std::optional<std::vector<Triangle>> WithoutCopies(const MeshView& mesh);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_TRIANGLE_COPIES_H_
