// Holes in upright surface that are part of a hole in the ground.
#ifndef TILEMEND_WORKER_FILL_PLANE_UPRIGHT_LOOPS_H_
#define TILEMEND_WORKER_FILL_PLANE_UPRIGHT_LOOPS_H_

#include <optional>
#include <vector>

#include "worker/fill/hole/local_hole.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {

struct UprightLoops {
  std::vector<Triangle> triangles;  // that close them; corners: vertices of the hole
  HolePart rest;                    // the hole without them; without segments if nothing else bounds it
};

// Closes the loops of a hole's boundary that are holes in a facade. Such a loop consists of original edges on objects,
// and its vector area is within 30 degrees of level. Seen from above it may lie within the hole in the ground, or touch
// its boundary in a vertex. Filled as ground, it would get a wall from each vertex down along the facade.
//   cell_hole  what `hole` was made of (MakeLocalHole)
// Loops that have no triangulation without crossings stay part of the rest. None if there are no others.
// O(rim log rim), and for each such loop as TriangulateInSpace.
std::optional<UprightLoops> CloseUprightLoops(const CellHole& cell_hole, const LocalHole& hole, CrossingCheck& check);

// Gives the new points of a patch the heights that another patch of the hole has there, in its triangles that face up.
// Others stay. So the ground beside a facade stays what it is with the ground that is known along the facade.
// O(points log triangles).
void TakeHeights(const LocalHole& hole, const LocalPatch& from, LocalPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_PLANE_UPRIGHT_LOOPS_H_
