#include "worker/fill/space/cone_fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/clip_ears.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// Shares of the loop that are left when the cone begins.
constexpr double kLeft[] = {1, 0.75, 0.5, 0.25, 0};
// Of the mean distance from the middle of the loop: how far tips are tried from there.
constexpr double kConeReaches[] = {0.15, 0.4, 0.8};
// Longer ones would take long, and no one tip sees all of them.
constexpr size_t kLongestBase = 200;

// An edge from there to the tip would have four triangles.
bool PassesAPlaceTwice(std::vector<Point3> base) {
  const auto is_before = [](const Point3& a, const Point3& b) { return std::ranges::lexicographical_compare(a, b); };
  std::ranges::sort(base, is_before);
  return std::ranges::adjacent_find(base) != base.end();
}

std::vector<Point3> TipsFor(std::span<const Point3> base) {
  Point3 middle = Point3::Zero();
  for (const Point3& p : base) middle += p / static_cast<double>(base.size());
  Vector3d across = Vector3d::Zero();
  double reach = 0;
  for (size_t i = 0; i < base.size(); ++i) {
    across += (base[i] - middle).cross(base[(i + 1) % base.size()] - middle);
    reach += (base[i] - middle).norm() / static_cast<double>(base.size());
  }
  std::vector<Point3> tips = {middle};
  const Vector3d along = base[0] - middle, up = across.normalized();
  const Vector3d u = (along - along.dot(up) * up).normalized(), v = up.cross(u);
  for (const double share : kConeReaches) {
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        for (int k = -1; k <= 1; ++k) {
          if (i == 0 && j == 0 && k == 0) continue;
          tips.emplace_back(middle + share * reach * (i * u + j * v + k * up).normalized());
        }
      }
    }
  }
  return tips;
}

// The area of the cone; infinite if it crosses something.
double SoundArea(std::span<const Point3> base, const Point3& tip, const CrossingIndex& taken) {
  constexpr double kNoCost = std::numeric_limits<double>::infinity();
  std::vector<SpaceTriangle> cone;
  double area = 0;
  for (size_t i = 0; i < base.size(); ++i) {
    const SpaceTriangle t = {base[i], base[(i + 1) % base.size()], tip};
    if (!HasArea(t) || TriangleArea(t[0], t[1], t[2]) <= 0 || taken.IsCrossedBy(t)) return kNoCost;
    area += TriangleArea(t[0], t[1], t[2]);
    cone.push_back(t);
  }
  return PatchCrosses(cone, {}) ? kNoCost : area;
}

}  // namespace

std::optional<ConeFill> CloseByCone(std::span<const Point3> loop, std::span<const Vector3d> outside,
                                    const std::function<bool(int32_t, int32_t)>& allowed, const CrossingIndex& surface,
                                    const std::function<Point3(const Point3&)>& place) {
  size_t before = 0;
  for (const double left : kLeft) {
    CrossingIndex taken = surface;
    const auto most = std::max(3, static_cast<int32_t>(std::lround(left * static_cast<double>(loop.size()))));
    ClippedLoop clipped = ClipEars(loop, outside, allowed, most, taken);
    if (clipped.rest.size() == before || clipped.rest.size() > kLongestBase) continue;
    before = clipped.rest.size();
    std::vector<Point3> base;
    for (const int32_t i : clipped.rest) base.push_back(loop[i]);
    if (PassesAPlaceTwice(base)) continue;
    double least = std::numeric_limits<double>::infinity();
    ConeFill cone;
    for (const Point3& wanted : TipsFor(base)) {
      const Point3 tip = place(wanted);
      const double area = tip.allFinite() ? SoundArea(base, tip, taken) : least;
      if (area >= least) continue;
      least = area;
      cone.tip = tip;
    }
    if (!std::isfinite(least)) continue;
    cone.triangles = std::move(clipped.triangles);
    for (size_t i = 0; i < base.size(); ++i) {
      cone.triangles.push_back(
          {clipped.rest[i], clipped.rest[(i + 1) % base.size()], static_cast<int32_t>(loop.size())});
    }
    return cone;
  }
  return std::nullopt;
}

}  // namespace tilemend
