// Moves the new points of a patch to where it passes through less.
#ifndef TILEMEND_WORKER_FILL_SPACE_MOVE_POINTS_H_
#define TILEMEND_WORKER_FILL_SPACE_MOVE_POINTS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Moves the new points at crossed triangles sideways, one by one, as long as fewer pairs of triangles cross
// (TrianglesCross): the foot of a wall that stands inside an uneven facade comes out of it. A point stays on the surface
// that faces up beside it. None of that turns, or rises or falls by more than a quarter of the point's way. A point goes
// at most half the mean length of its edges at once.
//   patch    sound otherwise (FaultOf)
//   surface  that it may not cross
//   crossed  triangles of the patch, rising
// Source: hill climbing over single vertices, as in mesh untangling (Freitag and Plassmann 2000). Deterministic. A few
// hundred tests for crossings a point.
void MovePoints(const LocalHole& hole, std::span<const SpaceTriangle> surface, std::span<const int32_t> crossed,
                LocalPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_MOVE_POINTS_H_
