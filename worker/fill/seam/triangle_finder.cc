#include "worker/fill/seam/triangle_finder.h"

#include <cstdint>
#include <vector>

namespace tilemend {
namespace {

constexpr double kOutside = 1e-9;  // share: a place on an edge is inside both triangles, whatever the rounding

Point3 Flat(const Point2& p) { return {p.x(), p.y(), 0}; }

double Cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

std::optional<Eigen::Vector3d> SharesAt(const Point2& place, const Point2& a, const Point2& b, const Point2& c) {
  const double area = Cross(b - a, c - a);
  if (area == 0) return std::nullopt;
  const Eigen::Vector3d share(Cross(b - place, c - place) / area, Cross(c - place, a - place) / area,
                              Cross(a - place, b - place) / area);
  return share.minCoeff() >= -kOutside ? std::optional(share) : std::nullopt;
}

}  // namespace

TriangleFinder::TriangleFinder(std::span<const Point3> points, std::span<const Triangle> triangles)
    : points_(points), triangles_(triangles) {
  std::vector<Eigen::AlignedBox3d> boxes(triangles.size());
  for (size_t t = 0; t < triangles.size(); ++t) {
    for (const int32_t corner : triangles[t]) boxes[t].extend(Flat(points[corner].head<2>()));
  }
  boxes_ = BoxTree(boxes);
}

std::optional<PlaceInTriangle> TriangleFinder::Find(const Point2& place) const {
  std::optional<PlaceInTriangle> found;
  boxes_.AnyMeeting(Eigen::AlignedBox3d(Flat(place)), [&](int32_t t) {
    const Triangle& triangle = triangles_[t];
    const auto at = [&](int k) { return Point2(points_[triangle[k]].head<2>()); };
    if (const auto share = SharesAt(place, at(0), at(1), at(2))) found = {triangle, *share};
    return found.has_value();
  });
  return found;
}

}  // namespace tilemend
