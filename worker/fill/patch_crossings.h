// Whether a patch passes through itself or through the surface around it.
#ifndef TILEMEND_WORKER_FILL_PATCH_CROSSINGS_H_
#define TILEMEND_WORKER_FILL_PATCH_CROSSINGS_H_

#include <array>
#include <span>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

using SpaceTriangle = std::array<Point3, 3>;

// Whether an edge of one triangle passes through another, for two triangles of the patch or one of the patch and one of
// the surface. Corners at equal positions are one vertex; triangles that share an edge cross only if one is folded onto
// the other. Triangles that overlap in one plane are not noticed unless they share an edge. Signs of volumes in double
// precision: a bare touch may count either way. O(n log n + pairs whose extents along the longest axis overlap).
bool PatchCrosses(std::span<const SpaceTriangle> patch, std::span<const SpaceTriangle> surface);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_PATCH_CROSSINGS_H_
