// Solves the equations of a thin plate on a large patch.
#ifndef TILEMEND_WORKER_FILL_SURFACE_TWO_LEVEL_SOLVER_H_
#define TILEMEND_WORKER_FILL_SURFACE_TWO_LEVEL_SOLVER_H_

#include <optional>

#include "worker/fill/surface/plate_equations.h"

namespace tilemend {

// Of the curvature, root mean square: where the iteration stops.
inline constexpr double kLeastError = 0.01;

// The heights of all points by conjugate gradients, from the interpolated solution on a coarser mesh (coarse_plate.h).
// The preconditioner has two levels: damped Jacobi, a coarse correction by sparse Cholesky, damped Jacobi. Stops when
// the energy of the remaining error is estimated at kLeastError^2 of the surface's. Then the curvature is right to that
// share (root mean square), or heights are to a millionth of the mean edge. Near-linear: about ten iterations whatever
// the size of the patch, and a coarse mesh that grows with the boundary. Some 150 bytes for each point.
//
// Nothing if the patch has no coarser mesh, if it does not converge, or if it is cancelled.
std::optional<PointValues> SolveInTwoLevels(const ThinPlateProblem& problem, const PlateEquations& equations);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_TWO_LEVEL_SOLVER_H_
