// Regions of the plane that users draw: waters, the area to cover.
#ifndef TILEMEND_COMMON_MESH_PLANE_POLYGON_H_
#define TILEMEND_COMMON_MESH_PLANE_POLYGON_H_

#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A polygon, or several, seen from above, in metres relative to the scene's origin. Rings are outlines and outlines of
// holes in any order and direction; each has at least three points and does not repeat the first. They may cross: a
// point is inside by the even-odd rule.
struct PlanePolygon {
  std::vector<std::vector<Point2>> rings;

  bool empty() const { return rings.empty(); }
};

// Whether `p` is inside. On the boundary itself either answer is possible. Cost O(points).
bool Contains(const PlanePolygon& polygon, const Point2& p);

// The area inside. Precondition: no rings cross. Cost O(points * rings).
double AreaOf(const PlanePolygon& polygon);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_PLANE_POLYGON_H_
