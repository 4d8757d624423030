// Heights along the edge of the area, where a hole has no rim.
#ifndef TILEMEND_WORKER_FILL_SURFACE_EDGE_HEIGHTS_H_
#define TILEMEND_WORKER_FILL_SURFACE_EDGE_HEIGHTS_H_

#include <vector>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// Fills in the heights at points of the edge, where the Laplacian alone says nothing: any harmonic surface has none.
// There it takes the heights that a plate on an unbounded plane, level far away, predicts from samples of the rim
// (kriging.h). A membrane carries on by how much the rim itself differs from them. The tension is the problem's, at
// least 3 / width^2, and as much more as it takes to keep within reach of the rim (height_reach.h). A membrane alone is
// used if that does not help, if the tension is that of a membrane, or if there are too few samples.
//
// Leaves heights at other unknown points that mean nothing. Returns false, with the heights as they were, if the system
// cannot be factorised. Cost of a factorisation for each tension.
//   width  of the hole, metres (hole_width.h)
//   edge   unknown points
bool SolveEdge(double width, const std::vector<int32_t>& edge, ThinPlateProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_EDGE_HEIGHTS_H_
