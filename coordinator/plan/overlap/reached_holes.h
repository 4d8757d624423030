// Tiles that reach far over their grid lines: where they have their own outline, and which other holes lie there.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_REACHED_HOLES_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_REACHED_HOLES_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Whether a vertex on a tile's own outline is farther from the one on the grid line that it follows than half an edge
// of the patch there: the slope at the line tells no height so far off.
bool IsFarOff(const Plan& plan, int32_t vertex);

// Pairs of open holes of two tiles: the own region of the first has such a vertex inside the second. Both are one hole,
// though they need not share a stretch of grid line. Not those that `touching` pairs join. Ascending. Cost O(vertices
// of own regions, each with the boundary of every hole of the cell that it lies in and that is not joined).
std::vector<std::pair<int32_t, int32_t>> HolesReached(const Plan& plan,
                                                      const std::vector<std::pair<int32_t, int32_t>>& touching);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_REACHED_HOLES_H_
