#include "coordinator/plan/rim/surface_gap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "common/mesh/segment_distance.h"
#include "coordinator/plan/rim/border_audit.h"
#include "coordinator/plan/types/meet_tolerance.h"

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

std::vector<Triangle> Within(const TriMesh& mesh, int axis, double lo, double hi) {
  std::vector<Triangle> within;
  for (const Triangle& t : mesh.triangles) {
    const double p = mesh.points[t[0]][axis], q = mesh.points[t[1]][axis], r = mesh.points[t[2]][axis];
    if (std::max({p, q, r}) >= lo && std::min({p, q, r}) <= hi) within.push_back(t);
  }
  return within;
}

Eigen::AlignedBox2d BoxOf(const TriMesh& mesh, const Triangle& t) {
  Eigen::AlignedBox2d box;
  for (const int32_t v : t) box.extend(Point2(mesh.points[v].head<2>()));
  return box;
}

BinGrid BinsOf(const TriMesh& mesh, const std::vector<Triangle>& triangles) {
  Eigen::AlignedBox2d extent(Point2(0, 0));
  if (!triangles.empty()) extent.setEmpty();
  for (const Triangle& t : triangles) extent.extend(BoxOf(mesh, t));
  return BinGrid(extent, kBin, static_cast<int32_t>(triangles.size()),
                 [&](int32_t t) { return BoxOf(mesh, triangles[t]); });
}

struct Distances {
  std::vector<double> near;  // in space
  std::vector<double> far;   // in height, of what is near nothing
};

// Of the vertices on a tile's outline, and beyond it where that is a zigzag.
void AddDistances(const TileOutline& of, const StripSurface& from, int axis, double outward, Distances& distances) {
  for (const BoundaryVertex& v : of.record.vertices) {
    if ((v.position[axis] - of.coordinate) * outward < -kMeetTolerance) continue;
    if (const auto distance = from.Distance(v.position)) {
      distances.near.push_back(*distance);
    } else if (const auto height = from.HeightDifference(v.position)) {
      distances.far.push_back(*height);
    }
  }
}

}  // namespace

StripSurface::StripSurface(const TriMesh& mesh, int axis, double lo, double hi)
    : mesh_(mesh), triangles_(Within(mesh, axis, lo, hi)), bins_(BinsOf(mesh, triangles_)) {}

std::optional<double> StripSurface::Distance(const Point3& p) const {
  double nearest = kFar;
  const Point2 at = p.head<2>(), reach(kFar, kFar);
  for (const int32_t t : bins_.In(Eigen::AlignedBox2d(Point2(at - reach), Point2(at + reach)))) {
    const auto& [a, b, c] = triangles_[t];
    nearest = std::min(nearest, DistanceToTriangle(p, mesh_.points[a], mesh_.points[b], mesh_.points[c]));
  }
  return nearest < kFar ? std::optional(nearest) : std::nullopt;
}

std::optional<double> StripSurface::HeightDifference(const Point3& p) const {
  std::optional<double> nearest;
  const Point2 at = p.head<2>();
  for (const int32_t t : bins_.In(Eigen::AlignedBox2d(at, at))) {
    const auto& [i, j, k] = triangles_[t];
    const Point3 &a = mesh_.points[i], &b = mesh_.points[j], &c = mesh_.points[k];
    const auto turn = [](const Point3& u, const Point3& v, const Point2& w) {
      return (v.x() - u.x()) * (w.y() - u.y()) - (v.y() - u.y()) * (w.x() - u.x());
    };
    const double of_a = turn(b, c, at), of_b = turn(c, a, at), of_c = turn(a, b, at), whole = of_a + of_b + of_c;
    if (whole == 0 || std::min({of_a / whole, of_b / whole, of_c / whole}) < 0) continue;
    const double height = std::abs((of_a * a.z() + of_b * b.z() + of_c * c.z()) / whole - p.z());
    if (!nearest || height < *nearest) nearest = height;
  }
  return nearest;
}

SurfaceGap MeasureGap(const TileOutline& a, const TileOutline& b, int axis) {
  const auto [lo, hi] = std::minmax(a.coordinate, b.coordinate);
  const double outward = a.coordinate > b.coordinate ? 1 : -1;
  Distances distances;
  AddDistances(a, StripSurface(b.record.band, axis, lo, hi), axis, outward, distances);
  AddDistances(b, StripSurface(a.record.band, axis, lo, hi), axis, -outward, distances);
  if (distances.far.size() > distances.near.size()) {
    distances.near.insert(distances.near.end(), distances.far.begin(), distances.far.end());
  }
  return SummaryOf(std::move(distances.near));
}

SurfaceGap SummaryOf(std::vector<double> distances) {
  SurfaceGap gap;
  gap.places = std::ssize(distances);
  if (distances.empty()) return gap;
  std::sort(distances.begin(), distances.end());
  const auto at = [&](double share) { return distances[static_cast<size_t>(share * (distances.size() - 1))]; };
  gap.median = at(0.5);
  gap.ninth_decile = at(0.9);
  gap.percentile_99 = at(0.99);
  return gap;
}

}  // namespace tilemend
