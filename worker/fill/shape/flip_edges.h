// Flips edges of a patch where that makes better triangles in space.
#ifndef TILEMEND_WORKER_FILL_SHAPE_FLIP_EDGES_H_
#define TILEMEND_WORKER_FILL_SHAPE_FLIP_EDGES_H_

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {

// A Delaunay triangulation has good triangles in its plane; where the surface over it is steep, other diagonals are
// better. Turns an edge if the two triangles beside it form a strictly convex quadrilateral in the plane (exact). The
// angle between the two may not grow. The worse of the two must get a better shape in space (4 sqrt(3) area / sum of
// squared edges). It begins at the triangles that are poor. A surface that is nowhere steep keeps its triangulation.
//   triangles  counter-clockwise in the plane; left as they are if they form no manifold (patch_mesh.h)
//   plane      per point: its place in the plane
//   points     per point: its place in space
//   walls      edges that stay
//   may_join   whether a new edge may join two points
// Each flip raises the worse of two shapes by more than rounding, so there is an end. Cost: linear in the triangles,
// plus the flips; deterministic.
std::vector<Triangle> FlipForShape(const std::vector<Triangle>& triangles, std::span<const LatticePoint> plane,
                                   std::span<const Point3> points, std::span<const RegionSegment> walls,
                                   const std::function<bool(int32_t, int32_t)>& may_join);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SHAPE_FLIP_EDGES_H_
