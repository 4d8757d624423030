// What is filled of a hole where tiles end at outlines of their own.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_OWN_REGIONS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_OWN_REGIONS_H_

#include "coordinator/plan/overlap/joint_tiles.h"

namespace tilemend {

// Gives every open hole of a plan that was made of `joint` its own region (PlannedHole::own_regions). Its boundary is
// all of the tile's chains that bound the hole, including folds and what lies beyond the grid lines. Between their ends
// it is the tile's outline, over vertices that follow those on the grid lines. Neighbours' regions overlap as the tiles
// do. Holes of a tile that a chain holds together become one. Cuts Plan::vertex_of_boundary down to the vertices of the
// tiles themselves. Cost O(n log n) in the boundary edges.
void LayOwnRegions(const PlanInput& input, const GridLines& own, const JointTiles& joint, Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_OWN_REGIONS_H_
