// Makes anew the parts of a patch that pass through it or through the surface around it.
#ifndef TILEMEND_WORKER_FILL_SPACE_MEND_CROSSINGS_H_
#define TILEMEND_WORKER_FILL_SPACE_MEND_CROSSINGS_H_

#include "worker/fill/hole/local_patch.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {

// First moves new points out of the way (move_points.h). Then takes out the triangles that still cross
// (TrianglesCross), and closes what is left open with triangles between the vertices there (sound_triangulation.h).
// Where that does not lead to a sound part, more is taken out around it, round by round. The boundary of the patch
// stays. What cannot be mended stays as it is, and is counted (LocalPatch::crossings). Returns the patch; without
// points that no triangle has left, if it has changed.
//   patch  sound otherwise (FaultOf)
// Source: Attene 2010, 3.4, where what intersects is removed with growing neighbourhoods and the holes are filled.
// O(triangles log triangles) where nothing crosses; else cubic in the longest loop, up to a bound.
LocalPatch MendCrossings(const LocalHole& hole, LocalPatch patch, CrossingCheck& check);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_MEND_CROSSINGS_H_
