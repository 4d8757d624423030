// Cuts a hole along creases into smooth parts.
#ifndef TILEMEND_WORKER_FILL_CREASE_PART_CUTTER_H_
#define TILEMEND_WORKER_FILL_CREASE_PART_CUTTER_H_

#include <cstdint>
#include <span>
#include <vector>

#include "worker/fill/crease/crease_network.h"
#include "worker/fill/hole/local_hole.h"

namespace tilemend {

// The parts of the hole on either side of the network's curves, and its islands in the parts that they lie in. An
// island is seen along the part's normal; of several parts it lies in the nearest. None if an island lies in no part.
// O(curves * rim).
//   new_points    the network's corners first, then points of curves
//   curve_points  for each curve the numbers of its new points in order, its ends left out
std::vector<PartBoundary> CutAlong(const CreaseNetwork& network, const LocalHole& hole,
                                   std::span<const Point3> new_points,
                                   const std::vector<std::vector<int32_t>>& curve_points);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_PART_CUTTER_H_
