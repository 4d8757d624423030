// The thin-plate surface of a triangulated patch: heights that minimise bending, with a little tension.
#ifndef TILEMEND_WORKER_FILL_SURFACE_THIN_PLATE_H_
#define TILEMEND_WORKER_FILL_SURFACE_THIN_PLATE_H_

#include <optional>
#include <vector>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// Heights of least |gradient|^2 over the patch at the unknown points. A free edge needs this: along it the Laplacian
// alone says nothing, since any harmonic surface has none. Same result and errors as SolveThinPlate, without
// Laplacians.
bool SolveMembrane(ThinPlateProblem& problem);

// Minimises the integral of |Laplacian|^2 + tension |gradient|^2 over the patch and the ring around it
// (docs/architecture.md, "The thin-plate surface"). The method is linear finite elements and lumped masses (mixed
// method). It solves (K M^-1 K + tension K) h = 0 at the unknown points. There M^-1 K h is the Laplacian; at a point
// without an equation it is taken as zero, or as given. A patch may be cut along a line whose heights and Laplacians
// are known from the whole patch. Either side then has the solution of the whole.
//
// Fills z of the unknown points. Returns the Laplacian at every point with an equation; elsewhere what is given of it,
// or 0. Returns nothing, with the heights as they were, if the system cannot be factorised or the problem is
// cancelled.
//
// Small systems are factorised (sparse Cholesky, Eigen). Large ones with even triangles are solved by iteration on two
// levels (two_level_solver.h), with curvatures right to 1 %. Cost near-linear in the points.
std::optional<std::vector<double>> SolveThinPlate(ThinPlateProblem& problem);

// Takes away the equation of rim points beside walls: band triangles that are steeper than 5 in 1 or face down. They
// have no slope to go on with, and the surface ends freely there.
void FreeSteepRim(ThinPlateProblem& problem);

// As SolveThinPlate, with as much more tension as it takes to keep the heights within reach of the rim. It grows by
// tens from 10 / extent^2 on. The reach above and below the rim is half its range of heights, and a quarter of the
// extent times the median slope beside it. Walls do not count for the slope. Leaves the tension that was used in the
// problem.
std::optional<std::vector<double>> SolveWithinReach(ThinPlateProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_THIN_PLATE_H_
