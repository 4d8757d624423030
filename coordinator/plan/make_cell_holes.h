// Takes from the plan and the survey records what a worker needs for the holes of one cell.
#ifndef TILEMEND_COORDINATOR_PLAN_MAKE_CELL_HOLES_H_
#define TILEMEND_COORDINATOR_PLAN_MAKE_CELL_HOLES_H_

#include <vector>

#include "common/records/cell_holes.h"
#include "coordinator/plan/seam/seam_heights.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// The given holes (of one cell, or of one cluster; without failure) with their vertices. If `with_band`, also the
// triangles of the cell's own tile and of its neighbours' at the holes' own vertices, and new vertices without a
// segment where the surface of the cluster is asked for: those of own regions far off the grid line. In a single mesh
// there is one ring more, since patches there go on with the curvature, too.
CellHoles MakeCellHoles(const Plan& plan, const PlanInput& input, const SeamHeights& heights,
                        const std::vector<int32_t>& holes, bool with_band);

// The same for filling: where tiles end at outlines of their own, up to those.
CellHoles MakeFillHoles(const Plan& plan, const PlanInput& input, const SeamHeights& heights,
                        const std::vector<int32_t>& holes, bool with_band = true);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_MAKE_CELL_HOLES_H_
