// Tiles that reach far over their grid lines: where they have their own outline, and which other holes lie there.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_REACHED_HOLES_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_REACHED_HOLES_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Whether a vertex on a tile's own outline is farther from the one on the grid line that it follows than half an edge
// of the patch there: the slope at the line tells no height so far off. With a quarter or a whole edge one of 100
// scenes of tiles with buffers changes.
bool IsFarOff(const Plan& plan, int32_t vertex);

// Pairs of open holes of two tiles: the own region of the first has such a vertex inside the second. Both are one hole,
// though they need not share a stretch of grid line. Ascending. Cost O(vertices of own regions, each with the boundary
// of every such hole in the cells around).
//   open      as for LayerHoles
//   touching  pairs that are joined anyway: none of what they join is named
std::vector<std::pair<int32_t, int32_t>> HolesReached(const Plan& plan, const std::vector<bool>& open,
                                                      const std::vector<std::pair<int32_t, int32_t>>& touching);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_REACHED_HOLES_H_
