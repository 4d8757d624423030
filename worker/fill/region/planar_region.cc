#include "worker/fill/region/planar_region.h"

#include <algorithm>

#include "common/mesh/vertex_lists.h"

namespace tilemend {

PlanarPoints RoundToWindow(std::span<const Point2> flat, std::span<const double> sizes) {
  Point2 lo = flat[0], hi = lo;
  for (const Point2& p : flat) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  PlanarPoints planar{LatticeWindow(lo, hi), {}, {}};
  for (size_t i = 0; i < flat.size(); ++i) {
    planar.points.push_back(planar.window.Round(flat[i]));
    planar.sizes.push_back(sizes[i] / planar.window.step());
  }
  return planar;
}

void KeepNewPoints(const std::vector<bool>& kept, std::span<const LatticePoint> points,
                   std::span<const RegionSegment> segments, RefinedRegion& region) {
  std::vector<LatticePoint> all(points.begin(), points.end()), left;
  for (size_t k = 0; k < kept.size(); ++k) {
    if (kept[k]) left.push_back(region.new_points[k]);
  }
  all.insert(all.end(), left.begin(), left.end());
  region.triangulation = TriangulateRegion(all, segments);
  const auto rim = static_cast<int32_t>(points.size());
  std::vector<int32_t> number(left.size(), -1);
  region.new_points.clear();
  for (Triangle& t : region.triangulation.triangles) {
    for (int32_t& v : t) {
      if (v < rim) continue;
      int32_t& n = number[v - rim];
      if (n < 0) {
        n = static_cast<int32_t>(region.new_points.size());
        region.new_points.push_back(left[v - rim]);
      }
      v = rim + n;
    }
  }
}

void MoveNewPoints(const LatticeWindow& window, const std::function<std::array<Point2, 2>(const Point2&)>& places,
                   std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                   RefinedRegion& region) {
  const auto rim = static_cast<int32_t>(points.size());
  const std::vector<Triangle>& triangles = region.triangulation.triangles;
  const VertexLists corners = CornersAt(triangles, points.size() + region.new_points.size());
  const auto at = [&](int32_t v) { return v < rim ? points[v] : region.new_points[v - rim]; };
  std::vector<bool> kept(region.new_points.size(), true);
  for (size_t k = 0; k < kept.size(); ++k) {
    const LatticePoint before = region.new_points[k];
    const std::span<const int32_t> around = corners.Of(rim + static_cast<int32_t>(k));
    const std::array<Point2, 2> wanted = places(window.ToMetres(before));
    kept[k] = std::any_of(wanted.begin(), wanted.end(), [&](const Point2& q) {
      region.new_points[k] = window.Round(q);
      return window.ToMetres(region.new_points[k]) == q &&
             std::all_of(around.begin(), around.end(), [&](int32_t corner) {
               const Triangle& t = triangles[corner >> 2];
               return Orientation(at(t[0]), at(t[1]), at(t[2])) > 0;
             });
    });
    if (!kept[k]) region.new_points[k] = before;
  }
  if (std::find(kept.begin(), kept.end(), false) != kept.end()) KeepNewPoints(kept, points, segments, region);
}

}  // namespace tilemend
