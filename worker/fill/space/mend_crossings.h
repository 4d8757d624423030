// Makes anew the parts of a patch that pass through it or through the surface around it.
#ifndef TILEMEND_WORKER_FILL_SPACE_MEND_CROSSINGS_H_
#define TILEMEND_WORKER_FILL_SPACE_MEND_CROSSINGS_H_

#include <functional>

#include "worker/fill/hole/local_patch.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {

// First moves new points out of the way (move_points.h). Then takes out the triangles that still cross, and closes what
// is left open with triangles between the vertices there, or with one new point (sound_triangulation.h, cone_fill.h).
// Where that does not lead to a sound part, more is taken out around it, round by round:
//   - first with triangles that cross nothing; in every second round they may cross surface that passes through the
//     hole's boundary, as every patch does there
//   - then also with some that cross (Misfits), if they are fewer than those that crossed before
// Boundaries that pass a vertex twice are also cut there. Vertices of the ground are put back where what closes a part
// passes them by too far (kept_ground.h).
// What ends at the outline of a tile is taken out only next to what crosses, so that it stays near the neighbour's.
// At last single points and edges are changed where triangles still cross (untangle_patch.h).
// A round counts if no more triangles cross than before, crossings that every patch has left aside (CrossedAvoidably).
// The boundary of the patch stays, but as UntanglePatch changes it. What cannot be mended stays as it is, and is
// counted (LocalPatch::crossings). Returns the patch; without points that no triangle has left, if it has changed.
//   patch         sound otherwise (FaultOf)
//   is_cancelled  asked before each round and each part of one; true ends it, with what is mended until then
// Source: Attene 2010, 3.4, where what intersects is removed with growing neighbourhoods and the holes are filled.
// O(triangles log triangles) where nothing crosses. Else up to 15 rounds, each as much again and for each loop the cube
// of its length, and what UntanglePatch costs. Loops of more than 150 vertices are not closed.
LocalPatch MendCrossings(const LocalHole& hole, LocalPatch patch, CrossingCheck& check,
                         const std::function<bool()>& is_cancelled = {});

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_MEND_CROSSINGS_H_
