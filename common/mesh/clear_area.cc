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

double Cross(const Point2& u, const Point2& v) { return u.x() * v.y() - u.y() * v.x(); }

// Whether the segment has a point inside the triangle, not only on its sides (separating axes).
bool LiesAcross(const PlaneSegment& segment, const std::array<Point2, 3>& corners) {
  const auto& [from, to] = segment;
  double low = 0, high = 0;  // of the corners, beside the line of the segment
  for (const Point2& p : corners) {
    const double side = Cross(to - from, p - from);
    low = std::min(low, side);
    high = std::max(high, side);
  }
  if (low >= 0 || high <= 0) return false;
  for (size_t k = 0; k < 3; ++k) {
    const Point2& a = corners[k];
    const Point2 side = corners[(k + 1) % 3] - a;
    const double turn = Cross(side, corners[(k + 2) % 3] - a) < 0 ? -1 : 1;
    if (std::max(turn * Cross(side, from - a), turn * Cross(side, to - a)) <= 0) return false;
  }
  return true;
}

// The outline of an area, to be asked for many triangles.
class OutlineIndex {
 public:
  explicit OutlineIndex(std::span<const PlaneSegment> outline) : outline_(outline) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const auto& [from, to] : outline) boxes.push_back(FlatBoxOf({{{from, to}}}));
    tree_ = BoxTree(boxes);
  }

  bool LiesAcrossIt(const MeshView& mesh, const Triangle& t) const {
    std::array<Point2, 3> corners;
    for (size_t k = 0; k < 3; ++k) corners[k] = mesh.points[t[k]].head<2>();
    const Eigen::AlignedBox3d box = FlatBoxOf({{{corners.begin(), corners.end()}}});
    return tree_.AnyMeeting(box, [&](int32_t s) { return LiesAcross(outline_[s], corners); });
  }

 private:
  std::span<const PlaneSegment> outline_;
  BoxTree tree_;
};

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
  std::vector<OutlineIndex> outlines;
  for (const ClearArea& area : areas) {
    indices.emplace_back(area.polygon);
    outlines.emplace_back(area.outline);
  }
  std::vector<int32_t> cleared_by;
  cleared_by.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Bounds box = BoundsOf(mesh, t);
    int32_t first = -1;
    tree.ForMeeting(box.lo.head<2>(), box.hi.head<2>(), [&](int32_t a) {
      const bool may_be_first = (first < 0 || a < first) && box.hi.z() <= areas[a].top;
      const bool goes = may_be_first && ShareInside(mesh, t, indices[a]) > kClearedShare;
      if (goes && !outlines[a].LiesAcrossIt(mesh, t)) first = a;
    });
    cleared_by.push_back(first);
  }
  return cleared_by;
}

}  // namespace tilemend
