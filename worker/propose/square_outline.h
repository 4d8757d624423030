// The outline of a set of squares as a polygon.
#ifndef TILEMEND_WORKER_PROPOSE_SQUARE_OUTLINE_H_
#define TILEMEND_WORKER_PROPOSE_SQUARE_OUTLINE_H_

#include "common/mesh/plane_polygon.h"
#include "worker/propose/square_set.h"

namespace tilemend {

// The polygon through the middles of the sides between squares of the set and others: no ring crosses or touches itself
// or another. Outlines of what is inside have it on their left. Square (0, 0) has its low corner at `corner`, and sides
// of `square` metres. Cost O(squares of the raster).
PlanePolygon OutlineOf(const SquareSet& set, double square);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PROPOSE_SQUARE_OUTLINE_H_
