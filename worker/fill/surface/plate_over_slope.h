// A thin plate over sloping ground.
#ifndef TILEMEND_WORKER_FILL_SURFACE_PLATE_OVER_SLOPE_H_
#define TILEMEND_WORKER_FILL_SURFACE_PLATE_OVER_SLOPE_H_

#include <functional>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// Solves for the heights of a plate that bends along a plane of that slope (dz/dx, dz/dy), where one over the ground
// would bend along the ground. `solve` fills in heights at the unknown points of the problem, in whatever coordinates
// that is, and says whether it could. It is called with the problem in those of the plane: first with each point's
// place on the plane along its vertical line; then, as long as no triangle of the patch faces down there, with its
// place along the normal, as found from the heights before. The points of the result stay on their vertical lines, so
// that seams stay where they are.
//
// Laplacians and the tension are those over the plane. A slope of zero changes nothing, not to the last bit. False if
// `solve` fails at first; the heights of unknown points mean nothing then. Cost: three of `solve`.
bool SolveOverSlope(const Point2& slope, ThinPlateProblem& problem, const std::function<bool()>& solve);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_PLATE_OVER_SLOPE_H_
