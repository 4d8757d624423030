// Fills a hole that lies over no plane, or steeply. A triangulation of its boundary is unrolled, refined in the plane,
// and lifted to the surface of least bending in space.
#ifndef TILEMEND_WORKER_FILL_SPACE_UNROLLED_FILL_H_
#define TILEMEND_WORKER_FILL_SPACE_UNROLLED_FILL_H_

#include <vector>

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Over a minimum-weight triangulation of the hole's one loop that does not cross itself (sound_triangulation.h). Not
// applicable if the hole has islands, a loop that touches itself, or more than kLongestSpatialLoop boundary vertices.
// The same if it has no triangulation, or that covers itself when it is unrolled. O(boundary^3 + new * boundary) and
// the cost of FairSurface.
LocalPatch FillUnrolled(const LocalHole& hole, const FillOptions& options);

// The same over given triangles of the loop's vertices. It goes the share `bend` of the way to the surface of least
// bending. With 0 it keeps to the triangles, so that the patch crosses little that they do not.
LocalPatch FillOver(std::vector<Triangle> triangles, double bend, const LocalHole& hole, const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_UNROLLED_FILL_H_
