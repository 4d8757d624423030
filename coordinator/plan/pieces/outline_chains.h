// Holes at the outline of a tile that ends where it likes: cut into chains that are closed one by one.
#ifndef TILEMEND_COORDINATOR_PLAN_PIECES_OUTLINE_CHAINS_H_
#define TILEMEND_COORDINATOR_PLAN_PIECES_OUTLINE_CHAINS_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct OutlineChains {
  std::vector<std::vector<RimSegment>> loops;  // each a chain and the straight segment that closes it, hole on the left
  std::vector<LeftOpen> left;
  std::vector<std::vector<int32_t>> open_runs;  // edges of the runs that cannot be closed on their own: open_runs.h
};

// Takes a loop of a tile apart that runs along the tile's outline (`closing` is another cell) or along other pieces of
// the tile (`piece_border` >= 0, see piece_borders.h). Every run of other edges between two such is closed by a
// straight segment between its ends if both lie on one side of the outline or in one plane of constant x, y or z; that
// segment stays open like the outline that it is a part of. Other runs are open. Cost linear in the loop.
OutlineChains CloseChains(const std::vector<int32_t>& loop, const Rim& rim, const GridLines& lines,
                          const ClosingCells& closing, const std::vector<double>& piece_border);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_PIECES_OUTLINE_CHAINS_H_
