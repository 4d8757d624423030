// Tiles cut from one mesh with a buffer: each has all triangles that touch its cell grown by a margin.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_BUFFERED_CUT_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_BUFFERED_CUT_H_

#include <array>
#include <optional>

#include "coordinator/plan/rim/border_audit.h"

namespace tilemend {

// Of each of the two tiles at a border: the smallest distance by which its outline, a zigzag, lies beyond the line of
// the border, metres. No value for a tile whose outline does not reach beyond.
using Buffers = std::array<std::optional<double>, 2>;

// No value if the tiles do not overlap. They do if both outlines reach beyond the line along a twentieth of the border.
// They also do if most boundary edges that both have run the same way in both. These are rims of holes, not outlines.
// Cost O(n log n) in the boundary edges.
//   cell, side  of the first tile; the other lies across the side
std::optional<Buffers> FindBuffers(const SurveyRecord& record, const SurveyRecord& other, const Grid& grid, CellId cell,
                                   Side side);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_BUFFERED_CUT_H_
