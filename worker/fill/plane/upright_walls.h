// Upright walls between a surface over the ground and what stands at its rim.
#ifndef TILEMEND_WORKER_FILL_PLANE_UPRIGHT_WALLS_H_
#define TILEMEND_WORKER_FILL_PLANE_UPRIGHT_WALLS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Takes the patch down from rim vertices on objects. Each gets a new vertex below it (or above), its foot, where the
// surface passes. The segments of the rim get triangles from there. Where one passes through level water, the water
// gets a vertex beside it, as upright triangles would overlap there. So the surface keeps its height up to the rim. The
// tiles on both sides of an overlap have it, wherever the objects end in each.
//
// Where tiles overlap (LocalHole::own_outline), feet lie straight below their vertices. Elsewhere they lie some
// millimetres inside the hole, so that walls face up and the fill is a height field. A foot stays straight below where
// the patch has no room, or the rim has a corner of less than 8 degrees.
//
//   ground  the height of the surface at every vertex of the hole; it counts at those on objects
//
// A vertex stays if the surface is close to it, or further off than the hole is wide. It also stays if the boundary
// comes by more than once. So does one at the end of a seam that another tile shares (LocalHole::own_outline is false),
// as that tile may see it otherwise. The patch must be a height field over the ground. Returns the new vertex of each
// vertex of the hole, -1 where there is none; empty without objects. O(triangles), and once more for each round in
// which a foot has no room.
std::vector<int32_t> RaiseWalls(const LocalHole& hole, std::span<const double> ground, LocalPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_PLANE_UPRIGHT_WALLS_H_
