// Fills a hole with triangles of its boundary in space, over no plane.
#ifndef TILEMEND_WORKER_FILL_SPACE_SPACE_FILL_H_
#define TILEMEND_WORKER_FILL_SPACE_SPACE_FILL_H_

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"
#include "worker/fill/space/crossing_index.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {

// A triangulation of a loop of vertices of the hole. It has no edge twice, makes none of `used` inside, and crosses
// nothing of `surface` (sound_triangulation.h). Empty if there is none.
std::vector<Triangle> TriangulateInSpace(const LocalHole& hole, const std::vector<int32_t>& loop,
                                         const std::set<VertexPair>& used, const CrossingIndex& surface);

// The hole's loops tied together by the shortest bridges, one after the other, which it adds to `bridges`. Empty if
// there are no loops, or some cannot be tied. O(rim^2 log rim) for each island.
std::vector<int32_t> JoinedLoop(const LocalHole& hole, std::set<VertexPair>& bridges);

// Triangulates the boundary so that the patch crosses neither itself nor the surface. Islands are tied to the rest by
// bridges, the shortest that lead to a sound patch. With Wang's surface the triangles are refined, adjusted and faired
// (ShapeAsWang) where that leads to a sound patch, else they are the patch. With the thin plate, a short hole of one
// loop is refined over these triangles (unrolled_fill.h). It gets all, half or none of the bending, whichever is sound
// first. Other holes, and those without a sound patch so, are refined and bent in space (faired_fill.h).
//   hole     closed, its vertices at folds without an equation
// A patch may yet be unsound: the caller checks it. Failures: too long a boundary, no bridge, none without a crossing.
LocalPatch FillInSpace(const LocalHole& hole, const FillOptions& options, CrossingCheck& check);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_SPACE_FILL_H_
