#include "worker/fill/shape/new_patch.h"

#include <algorithm>
#include <limits>

#include "common/mesh/exact_signs.h"

namespace tilemend {
namespace {

// A triangle on the plane keeps at least this height, as a share of its longest edge, or what it had.
constexpr double kLeastHeight = 0.05;
constexpr double kShares[] = {1, 0.5, 0.25};

// Of a triangle on the plane, over its longest edge; negative if it turns right.
double RelativeHeight(const Point3& a, const Point3& b, const Point3& c) {
  const Point2 u = (b - a).head<2>(), v = (c - a).head<2>();
  const double longest2 = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
  return longest2 > 0 ? (u.x() * v.y() - u.y() * v.x()) / longest2 : 0;
}

}  // namespace

PointMover::PointMover(NewPatch& patch) : patch_(patch), corners_(CornersAt(patch.triangles, patch.points.size())) {
  for (int32_t v = 0; v < patch.rim_count; ++v) reach_.extend(patch.points[v]);
  const Point3 more = Point3::Constant(reach_.diagonal().norm() / 2);
  reach_ = {reach_.min() - more, reach_.max() + more};
}

void PointMover::Move(int32_t v, const Point3& to) {
  const Point3 target = to.cwiseMax(reach_.min()).cwiseMin(reach_.max());
  Point3& p = patch_.points[v];
  const Point3 from = p;
  if (!patch_.projects) {
    p = target;
    return;
  }
  const double enough = std::min(LeastHeightAround(v), kLeastHeight);
  for (const double share : kShares) {
    p = from + share * (target - from);
    if (LeastHeightAround(v) >= enough) return;
  }
  p = Point3(from.x(), from.y(), target.z());
}

double PointMover::LeastHeightAround(int32_t v) const {
  double least = std::numeric_limits<double>::infinity();
  for (const int32_t corner : corners_.Of(v)) {
    const Triangle& t = patch_.triangles[corner >> 2];
    least = std::min(least, RelativeHeight(patch_.points[t[0]], patch_.points[t[1]], patch_.points[t[2]]));
  }
  return least;
}

bool PointMover::TurnsLeftAround(int32_t v) const {
  const auto flat = [&](int32_t i) { return Point2(patch_.points[i].head<2>()); };
  const auto around = corners_.Of(v);
  return std::all_of(around.begin(), around.end(), [&](int32_t corner) {
    const Triangle& t = patch_.triangles[corner >> 2];
    return TurnOf(flat(t[0]), flat(t[1]), flat(t[2])) > 0;
  });
}

}  // namespace tilemend
