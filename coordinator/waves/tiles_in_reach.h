// Which tiles the patches of a cell might run into.
#ifndef TILEMEND_COORDINATOR_WAVES_TILES_IN_REACH_H_
#define TILEMEND_COORDINATOR_WAVES_TILES_IN_REACH_H_

#include <set>

#include "common/records/cell_holes.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Of the cell's own tile and those that share its border exactly, those within reach (ReachOf) of a hole of the cell.
// Tiles that overlap are each filled for themselves.
std::set<CellId> TilesInReach(const CellHoles& cell, const Plan& plan, const PlanInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_TILES_IN_REACH_H_
