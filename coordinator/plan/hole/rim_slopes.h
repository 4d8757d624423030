// How steep the ground is that a hole lies in.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_RIM_SLOPES_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_RIM_SLOPES_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Sets PlannedHole::slope: the mean slope inside the rim of its cluster, or of a closed hole's own rim. The rim alone
// decides it: the slope is that of the plane across the rim's vector area. All holes of a cluster have the same,
// wherever the grid cuts. At most 2 (63 degrees). Zero where it is less than 0.25 (14 degrees) and where the rim faces
// down. If the cluster reaches the edge of the area, the surface ends freely there and goes on along the slope. The
// slope is then that of the plane through the rim by least squares. It is drawn to level in the directions in which the
// edge is far out and the rim does not reach. A rim that is straight says nothing of the slope across it. Cost O(n log
// n) in the segments.
void FindRimSlopes(Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_RIM_SLOPES_H_
