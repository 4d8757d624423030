// The surface that is linear between the ground at the rim of a hole.
#ifndef TILEMEND_WORKER_FILL_SURFACE_LINEAR_SURFACE_H_
#define TILEMEND_WORKER_FILL_SURFACE_LINEAR_SURFACE_H_

#include <optional>
#include <vector>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// The height at each of `at` on the Delaunay triangulation of `ground` over the plane; beyond its outline that of the
// nearest place on it. Of points over one place one counts. Precondition: ground is not empty. O((n + m) log n).
std::vector<double> LinearHeights(const std::vector<Point3>& ground, const std::vector<Point2>& at);

// Gives every point of the patch whose height is not known that of the surface that is linear between the ground points
// (CellHole::ground_points), with its edges rounded off a little; and the same to the points that stand on
// objects (`on_object`: for the first points of the problem), whose own heights count nothing. Where the ground under
// such a point is known (`ground`, as many, or none) it is that one, and the surface passes there too. Returns false,
// with the heights as they were, if the system cannot be factorised. Precondition: there are ground points. Cost: a
// membrane's solve.
bool SolveLinear(const std::vector<Point3>& ground_points, const std::vector<bool>& on_object,
                 const std::vector<std::optional<double>>& ground, ThinPlateProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_LINEAR_SURFACE_H_
