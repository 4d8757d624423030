// What is filled of a hole where tiles end at outlines of their own.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_OWN_REGIONS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_OWN_REGIONS_H_

#include "coordinator/plan/overlap/joint_tiles.h"

namespace tilemend {

// Gives every open hole of a plan that was made of `joint` its own region (PlannedHole::own_regions). Along the tile's
// chains of boundary it goes on from where they were cut to where they end at the tile's outline, and between them
// along the outline, over vertices that follow those of the seam on the grid line. Neighbours' regions overlap as the
// tiles do. Cuts Plan::vertex_of_boundary down to the vertices of the tiles themselves.
// Cost O(n log n) in the boundary edges.
void LayOwnRegions(const TileParts& parts, const JointTiles& joint, Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_OWN_REGIONS_H_
