#include "coordinator/plan/rim/surface_gap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "common/mesh/bin_grid.h"
#include "common/mesh/segment_distance.h"
#include "coordinator/plan/rim/border_audit.h"

namespace tilemend {
namespace {

constexpr double kBin = 1;  // metres
constexpr double kFar = 1;  // metres: what is farther is not the same surface

double DistanceToTriangle(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const auto left_of = [&](const Point3& u, const Point3& v) { return normal.cross(v - u).dot(p - u) >= 0; };
  const bool over = normal.squaredNorm() > 0 && left_of(a, b) && left_of(b, c) && left_of(c, a);
  if (over) return std::abs(normal.normalized().dot(p - a));
  return std::min({DistanceToSegment(p, a, b), DistanceToSegment(p, b, c), DistanceToSegment(p, c, a)});
}

// The triangles of a band that reach into a strip along a border.
class StripSurface {
 public:
  StripSurface(const TriMesh& band, int axis, double lo, double hi)
      : band_(band), triangles_(Within(band, axis, lo, hi)), bins_(MakeBins()) {}

  // From `p` to the nearest triangle; nothing if none is near.
  std::optional<double> Distance(const Point3& p) const {
    double nearest = kFar;
    const Point2 at = p.head<2>(), reach(kFar, kFar);
    for (const int32_t t : bins_.In(Eigen::AlignedBox2d(Point2(at - reach), Point2(at + reach)))) {
      const auto& [a, b, c] = triangles_[t];
      nearest = std::min(nearest, DistanceToTriangle(p, band_.points[a], band_.points[b], band_.points[c]));
    }
    return nearest < kFar ? std::optional(nearest) : std::nullopt;
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

  const TriMesh& band_;
  const std::vector<Triangle> triangles_;
  const BinGrid bins_;
};

// Of the vertices on a tile's outline, and beyond it where that is a zigzag.
void AddDistances(const TileOutline& of, const StripSurface& from, int axis, double outward,
                  std::vector<double>& distances) {
  for (const BoundaryVertex& v : of.record.vertices) {
    if ((v.position[axis] - of.coordinate) * outward < -kStraight) continue;
    if (const auto distance = from.Distance(v.position)) distances.push_back(*distance);
  }
}

}  // namespace

SurfaceGap MeasureGap(const TileOutline& a, const TileOutline& b, int axis) {
  const auto [lo, hi] = std::minmax(a.coordinate, b.coordinate);
  const double outward = a.coordinate > b.coordinate ? 1 : -1;
  std::vector<double> distances;
  AddDistances(a, StripSurface(b.record.band, axis, lo, hi), axis, outward, distances);
  AddDistances(b, StripSurface(a.record.band, axis, lo, hi), axis, -outward, distances);
  SurfaceGap gap;
  gap.places = std::ssize(distances);
  if (distances.empty()) return gap;
  std::sort(distances.begin(), distances.end());
  const auto at = [&](double share) { return distances[static_cast<size_t>(share * (distances.size() - 1))]; };
  gap.median = at(0.5);
  gap.ninth_decile = at(0.9);
  return gap;
}

}  // namespace tilemend
