#include "common/mesh/clear_area.h"

#include <algorithm>
#include <cstddef>

#include "common/mesh/polygon_index.h"
#include "common/mesh/polygon_tree.h"

namespace tilemend {
namespace {

struct Bounds {
  Point3 lo, hi;
};

Bounds BoundsOf(const MeshView& mesh, const Triangle& t) {
  Bounds box{mesh.points[t[0]], mesh.points[t[0]]};
  for (const int32_t v : {t[1], t[2]}) {
    box.lo = box.lo.cwiseMin(mesh.points[v]);
    box.hi = box.hi.cwiseMax(mesh.points[v]);
  }
  return box;
}

double ShareInside(const MeshView& mesh, const Triangle& t, const PolygonIndex& polygon) {
  const TrianglePoints points =
      PointsIn(mesh.points[t[0]].head<2>(), mesh.points[t[1]].head<2>(), mesh.points[t[2]].head<2>());
  const auto inside = std::ranges::count_if(points, [&](const Point2& p) { return polygon.Contains(p); });
  return static_cast<double>(inside) / static_cast<double>(points.size());
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

std::vector<int32_t> AreasThatClear(const MeshView& mesh, std::span<const ClearArea> areas) {
  const PolygonTree tree(areas.size(), [&](size_t a) -> const PlanePolygon& { return areas[a].polygon; });
  std::vector<PolygonIndex> indices;
  indices.reserve(areas.size());
  for (const ClearArea& area : areas) indices.emplace_back(area.polygon);
  std::vector<int32_t> cleared_by;
  cleared_by.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Bounds box = BoundsOf(mesh, t);
    int32_t first = -1;
    tree.ForMeeting(box.lo.head<2>(), box.hi.head<2>(), [&](int32_t a) {
      const bool may_be_first = (first < 0 || a < first) && box.hi.z() <= areas[a].top;
      if (may_be_first && ShareInside(mesh, t, indices[a]) > kClearedShare) first = a;
    });
    cleared_by.push_back(first);
  }
  return cleared_by;
}

}  // namespace tilemend
