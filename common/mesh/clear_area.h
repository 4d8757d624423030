// Which triangles of a mesh a user asks to take out: those in a polygon, up to a height.
#ifndef TILEMEND_COMMON_MESH_CLEAR_AREA_H_
#define TILEMEND_COMMON_MESH_CLEAR_AREA_H_

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/mesh/mesh_view.h"
#include "common/mesh/plane_polygon.h"

namespace tilemend {

using PlaneSegment = std::pair<Point2, Point2>;

// All in metres relative to the scene's origin.
struct ClearArea {
  PlanePolygon polygon;
  double top = 0;  // surface above this height stays; infinity: all goes
  // Parts of the outline of the scene's area. Triangles that lie across one stay: beyond the area nothing is filled.
  std::vector<PlaneSegment> outline = {};
};

// A triangle goes if more than this share of it, seen from above, lies in the polygon. Triangles are not cut, so along
// the outline some surface stays inside and some goes outside. The smaller the share, the less stays and the more goes.
// The experiment is in docs/decisions/2026-11-26-clear-polygons.md.
inline constexpr double kClearedShare = 0.1;

// 36 points spread evenly over a triangle: the centroids of the triangles that point up when each side is cut into 8.
inline constexpr int kPartsOfSide = 8;
using TrianglePoints = std::array<Point2, kPartsOfSide*(kPartsOfSide + 1) / 2>;
TrianglePoints PointsIn(const Point2& a, const Point2& b, const Point2& c);

// For each triangle the first area that takes it out, or -1 if it stays. An area takes out a triangle that has no
// corner above `top`, does not lie across its `outline`, and more than kClearedShare of which lies in the polygon. The
// share is measured at PointsIn.
// Pure. Cost O(n + points of the polygons) for n triangles, plus O(sqrt(points) + segments of the outline) for each
// triangle near a polygon.
std::vector<int32_t> AreasThatClear(const MeshView& mesh, std::span<const ClearArea> areas);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_CLEAR_AREA_H_
