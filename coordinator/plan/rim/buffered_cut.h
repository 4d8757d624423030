// Tiles cut from one mesh with a buffer: each has all triangles that touch its cell grown by a margin.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_BUFFERED_CUT_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_BUFFERED_CUT_H_

#include <array>
#include <optional>

#include "coordinator/plan/rim/border_audit.h"

namespace tilemend {

// How far beyond the line of a border the zigzag of each of two tiles begins at least, metres. No value for one that
// has none there.
using Buffers = std::array<std::optional<double>, 2>;

// No value if the tiles do not overlap. They overlap if their zigzags do along a twentieth of the border. They also
// overlap if most edges that both have as boundary are rims, the same way round in both. Rims are no zigzag. Cost O(n
// log n) in the boundary edges.
//   cell, side  of the first tile; the other lies across the side
std::optional<Buffers> FindBuffers(const SurveyRecord& record, const SurveyRecord& other, const Grid& grid, CellId cell,
                                   Side side);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_BUFFERED_CUT_H_
