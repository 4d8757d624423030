// Runs of rim edges too shallow to bound a hole of their own.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_SHALLOW_RUNS_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_SHALLOW_RUNS_H_

#include <vector>

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"

namespace tilemend {

// Gives runs of a loop's edges that one cell closes on to the cell around them. That is a run of x between y and y,
// which goes to y. Across a grid corner it goes to the cell that the rim passes through. All of the run must be within
// an edge's length of that cell's square. It must have no more edges than the runs beside it. On a clipped cut these
// are slivers that a tile has along its side, within the tolerance. Short runs first, so that they do not cut long ones
// in pieces. `closing` is by rim edge, as in closing_cells.h.
void CloseShallowRuns(const PlanInput& input, const GridLines& lines, const Rim& rim, const std::vector<int32_t>& loop,
                      std::vector<CellId>& closing);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_SHALLOW_RUNS_H_
