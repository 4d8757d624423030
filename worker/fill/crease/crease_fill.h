// Fills a closed hole in parts, along the sharp edges that go through it.
#ifndef TILEMEND_WORKER_FILL_CREASE_CREASE_FILL_H_
#define TILEMEND_WORKER_FILL_CREASE_CREASE_FILL_H_

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Carries the creases that enter the hole through it (crease_network.h), with vertices as far apart as the triangles
// there are large. Fills each part on its own (part_fill.h). Both parts at a crease close on its vertices. Islands
// belong to the part that they lie in; creases may end at them. Not applicable if no crease goes through the hole, or a
// part cannot be filled. The caller checks that the patch is sound.
LocalPatch FillAlongCreases(const LocalHole& hole, const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_CREASE_FILL_H_
