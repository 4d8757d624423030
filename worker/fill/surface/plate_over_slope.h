// A thin plate over sloping ground.
#ifndef TILEMEND_WORKER_FILL_SURFACE_PLATE_OVER_SLOPE_H_
#define TILEMEND_WORKER_FILL_SURFACE_PLATE_OVER_SLOPE_H_

#include <functional>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// Solves for the heights of a plate that bends along a plane of that slope (dz/dx, dz/dy), where one over the ground
// would bend along the ground. Calls `solve` once, with the problem in coordinates of the plane: each point's place on
// it along its vertical line, which is a stretch of the ground, and its distance from the plane. `solve` fills in
// heights at the unknown points and says whether it could. Points stay on their vertical lines, so that seams stay
// where they are.
//
// Laplacians and the tension are those over the plane. A slope of zero changes nothing, not to the last bit. Returns
// what `solve` does; where that is false the heights of unknown points mean nothing.
bool SolveOverSlope(const Point2& slope, ThinPlateProblem& problem, const std::function<bool()>& solve);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_PLATE_OVER_SLOPE_H_
