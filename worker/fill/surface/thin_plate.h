// The thin-plate surface of a triangulated patch: heights that minimise bending, with a little tension.
#ifndef TILEMEND_WORKER_FILL_SURFACE_THIN_PLATE_H_
#define TILEMEND_WORKER_FILL_SURFACE_THIN_PLATE_H_

#include <optional>
#include <vector>

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// Heights of least |gradient|^2 over the patch at the unknown points: what a free edge needs, along which the Laplacian
// alone says nothing (any harmonic surface has none). Same result and errors as SolveThinPlate, without Laplacians.
bool SolveMembrane(ThinPlateProblem& problem);

// Minimises the integral of |Laplacian|^2 + tension |gradient|^2 over the patch and the ring around it
// (docs/architecture.md, "The thin-plate surface"), with linear finite elements and lumped masses (mixed method):
// (K M^-1 K + tension K) h = 0 at the unknown points, where the Laplacian M^-1 K h at a point without an equation is
// taken as zero, or as given. A patch that is cut along a line whose heights and Laplacians are known from the whole
// patch has the solution of the whole patch on either side.
//
// Fills z of the unknown points; returns the Laplacian at every point with an equation (elsewhere what is given of it,
// or 0), or nothing, with the heights as they were, if the system cannot be factorised.
//
// Small systems are factorised (sparse Cholesky, Eigen); large ones with even triangles are solved by iteration on two
// levels (two_level_solver.h), with curvatures right to 1 %. Cost near-linear in the points.
std::optional<std::vector<double>> SolveThinPlate(ThinPlateProblem& problem);

// Takes away the equation of rim points beside band triangles that are steeper than 5 in 1 or face down, walls: they
// have no slope to go on with, and the surface ends freely there.
void FreeSteepRim(ThinPlateProblem& problem);

// SolveThinPlate with as much more tension, by tens from 10 / extent^2 on, as it takes to keep the heights within reach
// of the rim: half its range of heights, and a quarter of the extent times the median slope beside it but for walls,
// above and below. Leaves the tension that was used in the problem.
std::optional<std::vector<double>> SolveWithinReach(ThinPlateProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_THIN_PLATE_H_
