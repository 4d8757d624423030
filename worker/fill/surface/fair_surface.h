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
  // Those beyond, at the outer points of the band: tell how the curvature changes towards the rim. May be none.
  std::vector<Triangle> beyond;
  // Points with an equation of their own: everything around them is in patch and band. Others bend freely.
  std::vector<bool> has_equation;
  // In a mesh of any shape: the mean curvature, not the bend of the position, changes evenly.
  bool evens_curvature = false;
};

// Moves the unknown points so that the integral of |Laplacian of the position|^2 is least. Source: Botsch and Kobbelt
// 2004, "An intuitive framework for real-time freeform modeling". It uses cotangent weights after Pinkall and Polthier
// 1993, and lumped masses. The weights are those of `shape`: positions in which the patch triangles have the shapes
// that they should keep. In a second solve they are those of the surface found.
//
// Such a surface cuts off what is round. The Laplacian of the position is H n, with the mean curvature H as its length.
// With `evens_curvature` a step follows towards the surface on which the Laplacian of H is zero. So spheres and
// cylinders go on as they are. Source: Schneider and Kobbelt 2001, "Geometric fairing of irregular meshes for free-form
// surface design". The difference of the two, div(H grad n) + grad H grad n at the surface found, becomes the right
// side of the same equations. On the inside of a bend, where a surface is saddle-shaped, H has a Laplacian. It is as
// much, over the whole patch, as H flows in across the rim from `beyond`. That much of the step is not made; how much
// that is, is only believed as far as it is alike all along the rim.
//
// Then the surface of least bending, that of even curvature, and those of up to two more solves are compared. The one
// is taken whose curvature at the rim is nearest to that of the surface beside it. Further solves are left out where
// the first would change little by them, or has lost much of the area of its shapes. Beside the rough rims of tiles
// curvature is mostly noise.
//   shape  one position for each point; those of band triangles are taken from problem.points
// False, with the points as they were, if the system cannot be factorised. Sparse Cholesky; about O(n^1.5).
bool FairSurface(const std::vector<Point3>& shape, FairSurfaceProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_FAIR_SURFACE_H_
