// Refinement of a patch to the density of its surroundings.
#ifndef TILEMEND_WORKER_FILL_SHAPE_REFINE_PATCH_H_
#define TILEMEND_WORKER_FILL_SHAPE_REFINE_PATCH_H_

#include <cstdint>
#include <functional>

#include "worker/fill/region/refine_region.h"
#include "worker/fill/shape/new_patch.h"

namespace tilemend {

// Mesh refinement (Wang 2021, 3.3, which names the step alone; after Liepa 2003, 4). A triangle gets a point at its
// centroid c if each corner is far enough from c. Far enough is further than the sizes of c and of that corner, over
// sqrt 2. Then edges are turned until no triangle has a point of its neighbour within its circumcircle in space.
//
// The size at a centroid is the mean of the corners' if `options` are uniform or do not grow. Else it grows from the
// corners by `gradation` an edge, up to `size_limit` times the rim's mean.
//   may_join  whether an edge may run between two points of the rim; one that is there all the same gets a point in its
//             middle first
// Points of one round see none of each other: between long triangles side by side they would come too close. Where the
// patch spreads them, one that is too near another waits for the next round.
// A patch that projects still does. Precondition: manifold. O(n log n) expected; deterministic.
void RefinePatch(const RefineOptions& options, const std::function<bool(int32_t, int32_t)>& may_join, NewPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SHAPE_REFINE_PATCH_H_
