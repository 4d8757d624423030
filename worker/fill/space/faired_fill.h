// Fills a hole over a triangulation of its boundary, refined and bent in space.
#ifndef TILEMEND_WORKER_FILL_SPACE_FAIRED_FILL_H_
#define TILEMEND_WORKER_FILL_SPACE_FAIRED_FILL_H_

#include <vector>

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {

// Refines the triangles in space (refine_patch.h) and bends them to the surface of least bending. If that crosses
// itself or the surface around it, the new points there are taken back towards the triangles, round by round. The patch
// is the first that is sound. Where the turning of edges from rim to rim was what crossed, it is done without. Not
// applicable if no patch is sound.
//   triangles  over the hole's vertices; of any number of loops and bridges
// Triangles get larger than options.refine asks for where there would be more than 60,000 or so. Cost: about
// O(new^1.5), and O(new log new) for a round.
LocalPatch FillFaired(const std::vector<Triangle>& triangles, const LocalHole& hole, const FillOptions& options,
                      CrossingCheck& check);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_FAIRED_FILL_H_
