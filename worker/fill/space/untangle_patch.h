// Changes single points and edges of a patch while less of it crosses.
#ifndef TILEMEND_WORKER_FILL_SPACE_UNTANGLE_PATCH_H_
#define TILEMEND_WORKER_FILL_SPACE_UNTANGLE_PATCH_H_

#include <functional>
#include <span>

#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Hill climbing on the length of the curves along which the patch crosses avoidably (LiveCrossings::weight). At each
// triangle that crosses, the best of these changes is made:
//   - a new point moves, in one of 26 directions, or merges with one beside it
//   - an edge or a triangle is divided by a new point, there or beside it
//   - an edge is flipped
//   - where the hole ends at the tile's own outline, the same is done to the edge of the patch, and triangles beside it
//     are left out (patch_changes.h, free_outline.h)
// Points move and come in space, where MovePoints keeps to the plan. So a triangle with three vertices of the rim can
// go around what stands in its way. Triangles that cross each other, or that have a common vertex, are changed
// together, and are as they were if more of them cross in the end. What still crosses then is shaken: a change drawn by
// chance is made, and improved from there (iterated local search, Lourenço 2003). It stays if fewer triangles cross.
//   surface       of the input, all within reach
//   earlier       other patches
//   is_cancelled  asked before each triangle, and now and then between; true ends it
// The boundary of the patch stays, but for that outline (LocalPatch::left_edges). Surface that faces up goes on to do
// so. With each change it rises or falls by at most a quarter of the edges there. Water stays as it is. New points lie
// in the box of the patch, or an edge around it. Deterministic. O(n log n), and for each of at most kMaxTries changes
// tried the triangles near it and the curves through it; for each that is made, all curves.
void UntanglePatch(const LocalHole& hole, std::span<const SpaceTriangle> surface,
                   std::span<const SpaceTriangle> earlier, const std::function<bool()>& is_cancelled,
                   LocalPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_UNTANGLE_PATCH_H_
