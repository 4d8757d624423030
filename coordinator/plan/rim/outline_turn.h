// Whether tiles were cut along other axes than those of the scene.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_OUTLINE_TURN_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_OUTLINE_TURN_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// By which angle the straight outlines of overlapping tiles are turned against the grid, radians counter-clockwise: the
// median over the tiles that tell; 0 if they do not, or by less than kLeastTurn. A map's grid and a frame with x to the
// east differ by the convergence of the meridians, at most some degrees. Linear in the boundary edges.
double TurnOfTiles(const PlanInput& input);

inline constexpr double kLeastTurn = 1e-3;  // radians: 10 cm in 100 m

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_OUTLINE_TURN_H_
