// Where a tile's outline comes down from an object at the rim.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_WALL_FEET_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_WALL_FEET_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Puts the foot of a wall, a new vertex on the tile's outline, close to rim vertices on objects. It does so where a
// hole's own region goes on from there along the outline. It has the height of the surface. So the surfaces of two
// tiles meet up to there, however far apart the heights are at which the object ends in each. None where the next
// vertex is a hair off. O(segments).
void LayWallFeet(Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_WALL_FEET_H_
