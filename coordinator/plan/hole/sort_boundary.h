// Gives each cell its rim edges and seams.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_SORT_BOUNDARY_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_SORT_BOUNDARY_H_

#include <cstdint>
#include <map>
#include <vector>

#include "coordinator/plan/hole/cell_boundary.h"
#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/rim/rim_index.h"

namespace tilemend {

using CellBoundaries = std::map<CellId, CellBoundary>;

// Adds a loop of the rim. If one cell owns all of it and closes on all of it, the loop goes there whole, as a closed
// loop. Else it goes edge by edge to the cells that close on them, as far as they are in the area.
void AddLoop(const PlanInput& input, const GridLines& lines, const Rim& rim, const ClosingCells& closing,
             const std::vector<int32_t>& loop, CellBoundaries& boundaries);

// Adds the segments of a seam to the cells on both sides, as far as they are in the area. Where the seam follows a rim
// edge nothing lies between it and the surface. `index` is of `rim`.
void AddSeam(const PlanInput& input, const Rim& rim, const RimIndex& index, const Seam& seam,
             CellBoundaries& boundaries);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_SORT_BOUNDARY_H_
