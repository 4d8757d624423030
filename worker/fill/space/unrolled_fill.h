// Fills a hole that lies over no plane, or steeply: a triangulation of its boundary is unrolled, refined in the plane,
// and lifted to the surface of least bending in space.
#ifndef TILEMEND_WORKER_FILL_SPACE_UNROLLED_FILL_H_
#define TILEMEND_WORKER_FILL_SPACE_UNROLLED_FILL_H_

#include <vector>

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Over a minimum-weight triangulation of the hole's one loop that does not cross itself (sound_triangulation.h). Not
// applicable if the hole has islands, a loop that touches itself, more than kLongestSpatialLoop boundary vertices, or
// no triangulation, or if that covers itself when it is unrolled. O(boundary^3 + new * boundary) and the cost of
// FairSurface.
LocalPatch FillUnrolled(const LocalHole& hole, const FillOptions& options);

// The same over given triangles of the loop's vertices, the share `bend` of the way to the
// surface of least bending: 0 keeps to the triangles, so that the patch crosses little that they do not.
LocalPatch FillOver(std::vector<Triangle> triangles, double bend, const LocalHole& hole, const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_UNROLLED_FILL_H_
