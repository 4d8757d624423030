#include "common/mesh/clear_area.h"

#include <algorithm>

#include "common/mesh/polygon_index.h"

namespace tilemend {
namespace {

struct Bounds {
  Point3 lo, hi;
};

Bounds BoundsOf(const TriMesh& mesh, const Triangle& t) {
  Bounds box{mesh.points[t[0]], mesh.points[t[0]]};
  for (const int32_t v : {t[1], t[2]}) {
    box.lo = box.lo.cwiseMin(mesh.points[v]);
    box.hi = box.hi.cwiseMax(mesh.points[v]);
  }
  return box;
}

double ShareInside(const TriMesh& mesh, const Triangle& t, const PolygonIndex& polygon) {
  const TrianglePoints points =
      PointsIn(mesh.points[t[0]].head<2>(), mesh.points[t[1]].head<2>(), mesh.points[t[2]].head<2>());
  const auto inside = std::ranges::count_if(points, [&](const Point2& p) { return polygon.Contains(p); });
  return static_cast<double>(inside) / static_cast<double>(points.size());
}

bool Clears(const ClearArea& area, const PolygonIndex& polygon, const TriMesh& mesh, const Triangle& t) {
  const Bounds box = BoundsOf(mesh, t);
  if (box.hi.z() > area.top) return false;
  const bool apart = (box.hi.head<2>().array() < polygon.lo().array()).any() ||
                     (box.lo.head<2>().array() > polygon.hi().array()).any();
  return !apart && ShareInside(mesh, t, polygon) > kClearedShare;
}

}  // namespace

TrianglePoints PointsIn(const Point2& a, const Point2& b, const Point2& c) {
  const Point2 u = (b - a) / kPartsOfSide, v = (c - a) / kPartsOfSide;
  TrianglePoints points;
  size_t next = 0;
  for (int i = 0; i < kPartsOfSide; ++i) {
    for (int j = 0; i + j < kPartsOfSide; ++j) points[next++] = a + (i + 1.0 / 3) * u + (j + 1.0 / 3) * v;
  }
  return points;
}

std::vector<int32_t> AreasThatClear(const TriMesh& mesh, std::span<const ClearArea> areas) {
  std::vector<int32_t> cleared_by(mesh.triangles.size(), -1);
  for (size_t a = 0; a < areas.size(); ++a) {
    const PolygonIndex polygon(areas[a].polygon);
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (cleared_by[t] < 0 && Clears(areas[a], polygon, mesh, mesh.triangles[t])) {
        cleared_by[t] = static_cast<int32_t>(a);
      }
    }
  }
  return cleared_by;
}

}  // namespace tilemend
