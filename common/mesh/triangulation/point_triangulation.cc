#include "common/mesh/triangulation/point_triangulation.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace tilemend {
namespace {

constexpr double kFrame = 4;  // times the extent of the places: so far around them

}  // namespace

PointTriangulation TriangulatePoints(const std::vector<Point3>& points, const Eigen::AlignedBox2d& places) {
  const Point2 reach = Point2::Constant(kFrame * std::max(places.sizes().maxCoeff(), 1.0));
  const Eigen::AlignedBox2d frame(places.min() - reach, places.max() + reach);
  const LatticeWindow window(frame.min(), frame.max());
  std::vector<LatticePoint> on_lattice;
  for (const Point3& p : points) on_lattice.push_back(window.Round(p.head<2>()));
  const auto first = static_cast<int32_t>(points.size());
  for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                            Eigen::AlignedBox2d::TopRight, Eigen::AlignedBox2d::TopLeft}) {
    on_lattice.push_back(window.Round(frame.corner(corner)));
  }
  const std::vector<RegionSegment> outline = {
      {first, first + 1}, {first + 1, first + 2}, {first + 2, first + 3}, {first + 3, first}};
  RegionTriangulation mesh = TriangulateRegion(on_lattice, outline);
  return {window, std::move(on_lattice), std::move(mesh)};
}

}  // namespace tilemend
