// Lets the surface pass under what stands at the rim of a hole.
#ifndef TILEMEND_WORKER_FILL_SURFACE_FREE_RIM_H_
#define TILEMEND_WORKER_FILL_SURFACE_FREE_RIM_H_

#include <optional>
#include <vector>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// Gives the points that stand on objects (`on_object`: for the first points of the problem) the heights that the
// surface would have there without them, as known heights: those of the plane through the other known points of the
// patch, less steep by the share of their variance that it does not explain, plus the membrane over what these have
// beside it. A rim of one plane gives that plane; one of steps does not go on with their slope. Where such a height
// is known (`ground`, as many as `on_object`, or none) it is that one. The rows of triangles at such points then rise
// to the objects themselves as a wall, once their own heights are put back.
//
// Takes away the band at these points, and the equations of those that would be left without a full ring. Nothing is
// changed at points from which no way through the patch leads to ground but over known points, and where no point
// stands on an object, or fewer than three other points of the patch are known. Returns false, with the heights as they
// were, if the system cannot be factorised. Cost: a membrane's solve.
bool FreeRim(const std::vector<bool>& on_object, const std::vector<std::optional<double>>& ground,
             ThinPlateProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_FREE_RIM_H_
