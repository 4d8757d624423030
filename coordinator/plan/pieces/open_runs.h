// Runs of rim edges across a tile, joined to holes.
#ifndef TILEMEND_COORDINATOR_PLAN_PIECES_OPEN_RUNS_H_
#define TILEMEND_COORDINATOR_PLAN_PIECES_OPEN_RUNS_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct LinkedRuns {
  std::vector<std::vector<RimSegment>> loops;  // hole on the left
  std::vector<LeftOpen> left;
};

// Joins open runs of one tile (edges in order), of any of its loops, to loops by straight segments between ends on one
// side of the tile or in one plane, nearest ends first: a hole that crosses a piece from side to side has a run on
// either bank. Runs that stay over are left. Cost O(n^2 log n) in the runs.
LinkedRuns LinkRuns(const std::vector<std::vector<int32_t>>& runs, const Rim& rim, const GridLines& lines);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_PIECES_OPEN_RUNS_H_
