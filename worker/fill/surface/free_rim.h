// Lets the surface pass under what stands at the rim of a hole.
#ifndef TILEMEND_WORKER_FILL_SURFACE_FREE_RIM_H_
#define TILEMEND_WORKER_FILL_SURFACE_FREE_RIM_H_

#include <optional>
#include <vector>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// Gives the points that stand on objects the heights that the surface would have there without them, as known heights.
// For the first points of the problem, `on_object` says which stand on objects. These are the heights of the plane
// through the other known points of the patch. That plane is made less steep by the share of their variance that it
// does not explain. The membrane over what these have beside that plane is added. A rim of one plane gives that plane;
// one of steps does not go on with their slope. Where such a height is known (`ground`, as many, or none) it is that
// one, on objects or not. The rows of triangles at such points then rise to the objects themselves as a wall, once
// their own heights are put back.
//
// Takes away the band at these points, and the equations of those that would be left without a full ring. Nothing
// changes at points from which every way through the patch to ground leads over known points. Nothing changes if no
// point stands on an object, or fewer than three other points of the patch are known. Returns false, with the heights
// as they were, if the system cannot be factorised. Cost: a membrane's solve.
bool FreeRim(const std::vector<bool>& on_object, const std::vector<std::optional<double>>& ground,
             ThinPlateProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_FREE_RIM_H_
