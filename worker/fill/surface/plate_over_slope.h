// A thin plate over sloping ground.
#ifndef TILEMEND_WORKER_FILL_SURFACE_PLATE_OVER_SLOPE_H_
#define TILEMEND_WORKER_FILL_SURFACE_PLATE_OVER_SLOPE_H_

#include <functional>
#include <optional>
#include <vector>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// Heights at the unknown points of the problem, and the Laplacian at each point with an equation; nothing if the system
// cannot be factorised. May choose the problem's tension, make points known and take equations away.
using PlateSolver = std::function<std::optional<std::vector<double>>()>;

// Solves for the heights of a plate that bends along sloping ground. A plate over the ground would bend along the plane
// of x and y. There are two solves. The first calls `solve` with the problem in coordinates of a plane of that slope
// (dz/dx, dz/dy). A point's place on it is where its vertical line meets it, in lengths along the plane; its height is
// the distance from the plane. The second solves along the surface that came of it, with the same tension. Where the
// ground falls to one side and rises to the other, no plane lies along all of it. Points stay on their vertical lines,
// so that seams stay where they are.
//
// Laplacians and the tension are those along the surface. A slope of zero calls `solve` alone, and changes nothing, not
// to the last bit. Where nothing is returned the heights of unknown points mean nothing. Costs a solve more.
std::optional<std::vector<double>> SolveOverSlope(const Point2& slope, ThinPlateProblem& problem,
                                                  const PlateSolver& solve);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_PLATE_OVER_SLOPE_H_
