// Shapes a patch by its normals.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_POISSON_PATCH_H_
#define TILEMEND_WORKER_PAPERS_FRONT_POISSON_PATCH_H_

#include <Eigen/Core>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Zhao et al. 2007, as Xu 2014, 2.3 tells it. Normals of the new points are harmonic between those of the rim. Each
// triangle is turned about its middle to the mean normal of its corners. Then points are moved so that the triangles
// have the edges that they got by turning. That is in the sense of the cotangent Poisson equation with the rim as
// Dirichlet boundary.
//   rim_normals  any length; those without one count as the patch's own there
//   points       those of the rim first
// False, with the points as they were, if there is no solution.
bool ShapeByNormals(std::span<const Eigen::Vector3d> rim_normals, std::span<const Triangle> triangles,
                    std::vector<Point3>& points);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_POISSON_PATCH_H_
