// The surface of least bending in space that goes on from its surroundings.
#ifndef TILEMEND_WORKER_FILL_SURFACE_FAIR_SURFACE_H_
#define TILEMEND_WORKER_FILL_SURFACE_FAIR_SURFACE_H_

#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

struct FairSurfaceProblem {
  std::vector<Point3> points;
  std::vector<bool> known;  // positions that stay
  std::vector<Triangle> patch;
  std::vector<Triangle> band;  // original triangles at the rim, over known points: give the slope there
  // Points with an equation of their own: everything around them is in patch and band. Others bend freely.
  std::vector<bool> has_equation;
  int solves = 1;  // > 0
};

// Moves the unknown points so that the integral of |Laplacian of the position|^2 is least (Botsch and Kobbelt 2004,
// "An intuitive framework for real-time freeform modeling"; cotangent weights after Pinkall and Polthier 1993, lumped
// masses). The weights are those of `shape`: positions in which the patch triangles have the shapes that they should
// keep; those of a second solve are of the surface found. On smooth bodies a second one makes round surfaces flatter,
// and further off; beside the rough rims of tiles it is nearer (a dome of 6 m: .20 against .30 m in the mean).
//   shape  one position for each point; those of band triangles are taken from problem.points
// False, with the points as they were, if the system cannot be factorised. Sparse Cholesky; about O(n^1.5).
bool FairSurface(const std::vector<Point3>& shape, FairSurfaceProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_FAIR_SURFACE_H_
