#include "worker/fill/surface/hole_width.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <compare>
#include <unordered_map>
#include <vector>

#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

constexpr double kShareBelow = 0.5;  // of the area in circles that are smaller: the median

double Circumdiameter(const Point3& a, const Point3& b, const Point3& c, double area) {
  return (a - b).head<2>().norm() * (b - c).head<2>().norm() * (c - a).head<2>().norm() / (2 * area);
}

// A triangle of a region.
struct Share {
  double diameter;  // of its circle, metres
  double area;
  auto operator<=>(const Share&) const = default;
};

// The Delaunay triangles of the region that segments bound, on a lattice of its own.
std::vector<Share> SharesOf(std::span<const Point3> points, std::span<const RegionSegment> segments) {
  Point2 lo = points[segments[0].from].head<2>(), hi = lo;
  for (const RegionSegment& s : segments) {
    lo = lo.cwiseMin(points[s.from].head<2>());
    hi = hi.cwiseMax(points[s.from].head<2>());
  }
  const LatticeWindow window(lo, hi);
  std::vector<LatticePoint> lattice;
  std::vector<RegionSegment> own;
  std::unordered_map<int32_t, int32_t> number;
  const auto local = [&](int32_t v) {
    const auto [it, fresh] = number.try_emplace(v, static_cast<int32_t>(lattice.size()));
    if (fresh) lattice.push_back(window.Round(points[v].head<2>()));
    return it->second;
  };
  for (const RegionSegment& s : segments) {
    const int32_t from = local(s.from);
    own.push_back({from, local(s.to)});
  }
  std::vector<Point3> flat;
  for (const LatticePoint& p : lattice) flat.emplace_back(window.ToMetres(p).x(), window.ToMetres(p).y(), 0);
  std::vector<Share> shares;
  for (const Triangle& t : TriangulateRegion(lattice, own).triangles) {
    const Point3 &a = flat[t[0]], &b = flat[t[1]], &c = flat[t[2]];
    const double area = TwiceVectorArea(a, b, c).z() / 2;
    shares.push_back({Circumdiameter(a, b, c, area), area});
  }
  return shares;
}

}  // namespace

double HoleWidth(std::span<const Point3> points, std::span<const RegionSegment> segments) {
  if (segments.empty()) return 0;
  std::vector<Share> shares = SharesOf(points, segments);
  double total = 0, sum = 0;
  for (const Share& s : shares) total += s.area;
  std::sort(shares.begin(), shares.end());
  for (const Share& s : shares) {
    sum += s.area;
    if (sum >= kShareBelow * total) return s.diameter;
  }
  return 0;
}

}  // namespace tilemend
