#include "coordinator/plan/rim/overlap_heights.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "common/mesh/bin_grid.h"
#include "coordinator/plan/rim/border_audit.h"

namespace tilemend {
namespace {

constexpr double kBin = 1;          // metres
constexpr double kUpright = 1e-12;  // m2: a triangle that covers less, seen from above, has no height at a place

// The triangles of a band that reach into a strip along a border.
class StripSurface {
 public:
  StripSurface(const TriMesh& band, int axis, double lo, double hi)
      : band_(band), triangles_(Within(band, axis, lo, hi)), bins_(MakeBins()) {}

  // The vertical distance from `p` to the nearest triangle over or under it.
  std::optional<double> Distance(const Point3& p) const {
    std::optional<double> nearest;
    const Point2 at = p.head<2>();
    for (const int32_t t : bins_.In(Eigen::AlignedBox2d(at, at))) {
      const std::optional<double> height = HeightOf(triangles_[t], at);
      if (height && (!nearest || std::abs(*height - p.z()) < *nearest)) nearest = std::abs(*height - p.z());
    }
    return nearest;
  }

 private:
  static std::vector<Triangle> Within(const TriMesh& band, int axis, double lo, double hi) {
    std::vector<Triangle> within;
    for (const Triangle& t : band.triangles) {
      const double p = band.points[t[0]][axis], q = band.points[t[1]][axis], r = band.points[t[2]][axis];
      if (std::max({p, q, r}) >= lo && std::min({p, q, r}) <= hi) within.push_back(t);
    }
    return within;
  }

  Eigen::AlignedBox2d BoxOf(const Triangle& t) const {
    Eigen::AlignedBox2d box;
    for (const int32_t v : t) box.extend(Point2(band_.points[v].head<2>()));
    return box;
  }

  BinGrid MakeBins() const {
    Eigen::AlignedBox2d extent(Point2(0, 0));
    if (!triangles_.empty()) extent.setEmpty();
    for (const Triangle& t : triangles_) extent.extend(BoxOf(t));
    return BinGrid(extent, kBin, static_cast<int32_t>(triangles_.size()),
                   [this](int32_t t) { return BoxOf(triangles_[t]); });
  }

  std::optional<double> HeightOf(const Triangle& t, const Point2& p) const {
    const Point3 &a = band_.points[t[0]], &b = band_.points[t[1]], &c = band_.points[t[2]];
    const auto turn = [](const Point2& u, const Point2& v) { return u.x() * v.y() - u.y() * v.x(); };
    const Point2 ab = (b - a).head<2>(), ac = (c - a).head<2>(), ap = p - a.head<2>();
    const double area = turn(ab, ac);
    if (std::abs(area) < kUpright) return std::nullopt;
    const double at_b = turn(ap, ac) / area, at_c = turn(ab, ap) / area;
    if (at_b < 0 || at_c < 0 || at_b + at_c > 1) return std::nullopt;
    return a.z() + at_b * (b.z() - a.z()) + at_c * (c.z() - a.z());
  }

  const TriMesh& band_;
  const std::vector<Triangle> triangles_;
  const BinGrid bins_;
};

void AddDistances(const TileOutline& of, const StripSurface& from, int axis, std::vector<double>& distances) {
  for (const BoundaryVertex& v : of.record.vertices) {
    if (std::abs(v.position[axis] - of.coordinate) > kStraight) continue;
    if (const auto distance = from.Distance(v.position)) distances.push_back(*distance);
  }
}

}  // namespace

HeightGap CompareHeights(const TileOutline& a, const TileOutline& b, int axis) {
  const auto [lo, hi] = std::minmax(a.coordinate, b.coordinate);
  std::vector<double> distances;
  AddDistances(a, StripSurface(b.record.band, axis, lo, hi), axis, distances);
  AddDistances(b, StripSurface(a.record.band, axis, lo, hi), axis, distances);
  HeightGap gap;
  gap.places = std::ssize(distances);
  if (distances.empty()) return gap;
  std::sort(distances.begin(), distances.end());
  const auto at = [&](double share) { return distances[static_cast<size_t>(share * (distances.size() - 1))]; };
  gap.median = at(0.5);
  gap.ninth_decile = at(0.9);
  return gap;
}

}  // namespace tilemend
