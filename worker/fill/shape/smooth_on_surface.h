// Moves vertices of a patch along its surface where that makes better triangles in space.
#ifndef TILEMEND_WORKER_FILL_SHAPE_SMOOTH_ON_SURFACE_H_
#define TILEMEND_WORKER_FILL_SHAPE_SMOOTH_ON_SURFACE_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {

// Where a vertex can be near a place of the plane (metres): on the lattice of the triangulation, and there to the bit.
using PlacePoint = std::function<std::optional<std::pair<LatticePoint, Point2>>(const Point2&)>;

// Whether triangles that are well shaped in the plane are not in space. That is so if the root mean square slope of the
// patch is above 0.25, at which an equilateral triangle has a quality of 0.998.
bool IsSteepPatch(const std::vector<Triangle>& triangles, const std::vector<Point3>& points);

// One round over the vertices from `first_movable` on. A vertex goes to where the shapes of the triangles around it are
// best in space (4 sqrt(3) area / sum of squared edges). It stays if that makes one of them poor or turns one over
// (exact). Its height there is that of the surface. It is the mean of two heights: that on the triangles as they are,
// and that on the tangent planes at their corners. These lie on opposite sides of a curved surface.
//   triangles  counter-clockwise in the plane
//   plane      per point: its place in the plane; those that move get a new one
//   points     per point: its place in space; the same
// Cost linear in the triangles; deterministic.
void SmoothOnSurface(const std::vector<Triangle>& triangles, int32_t first_movable, const PlacePoint& place,
                     std::vector<LatticePoint>& plane, std::vector<Point3>& points);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SHAPE_SMOOTH_ON_SURFACE_H_
