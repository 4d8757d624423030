// Moves the new points of a patch to where it passes through less.
#ifndef TILEMEND_WORKER_FILL_SPACE_MOVE_POINTS_H_
#define TILEMEND_WORKER_FILL_SPACE_MOVE_POINTS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Moves the new points at crossed triangles in plan, one by one, as long as fewer pairs of triangles cross
// (TrianglesCross): the foot of a wall that stands inside an uneven facade comes out of it. A point on surface that
// faces up stays on that surface, which rises or falls by at most a quarter of the point's way; water keeps its level.
// No triangle turns over. A point goes at most half the mean length of its edges at once, in all at most twice that
// length beyond the box of the triangles around it, and never out of the box of the patch. Vertices of the hole stay.
//   patch    sound otherwise (FaultOf)
//   surface  that it may not cross
//   crossed  triangles of the patch, rising
// Source: hill climbing over single vertices, as in mesh untangling (Freitag and Plassmann 2000). Deterministic. At
// most some hundred tests for crossings a point, and a bounded number in all.
void MovePoints(const LocalHole& hole, std::span<const SpaceTriangle> surface, std::span<const int32_t> crossed,
                LocalPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_MOVE_POINTS_H_
