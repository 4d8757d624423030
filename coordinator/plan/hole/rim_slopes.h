// How steep the ground is that a hole lies in.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_RIM_SLOPES_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_RIM_SLOPES_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Sets PlannedHole::slope: the mean slope inside the rim of its cluster, or of a closed hole's own, which the rim alone
// tells (that of the plane across its vector area). All holes of a cluster have the same, wherever the grid cuts. Where
// a cluster reaches the edge of the area, its rim goes on straight from one end to the other. At most 2 (63 degrees);
// zero where it is less than 0.25 (14 degrees) or the rim faces down. Cost O(n log n) in the segments.
void FindRimSlopes(Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_RIM_SLOPES_H_
