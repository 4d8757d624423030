#include "worker/fill/crease/rim_touches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "worker/fill/crease/crease_measures.h"

namespace tilemend {
namespace {

using internal::kOnCrease;
using internal::Wrap;

// Pieces of a curve when distances from it are measured.
constexpr int kCurvePieces = 64;

// Where a curve, given by points at even parameters, comes nearest to p, and how near.
std::pair<double, double> Nearest(const std::vector<Point3>& line, const Point3& p) {
  std::pair<double, double> nearest{0, INFINITY};
  for (size_t k = 0; k + 1 < line.size(); ++k) {
    const Eigen::Vector3d way = line[k + 1] - line[k];
    const double t = std::clamp((p - line[k]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double distance = (p - line[k] - t * way).norm();
    if (distance < nearest.second) nearest = {(static_cast<double>(k) + t) / kCurvePieces, distance};
  }
  return nearest;
}

}  // namespace

RimTouches::RimTouches(std::span<const RimLoop> loops) : loops_(loops) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (size_t l = 0; l < loops.size(); ++l) {
    const int32_t n = loops[l].size();
    for (int32_t i = 0; i < n; ++i) {
      const Point3& p = loops[l].positions[i];
      const double edges =
          (loops[l].positions[Wrap(i + 1, n)] - p).norm() + (loops[l].positions[Wrap(i - 1, n)] - p).norm();
      const double reach = kOnCrease * edges / 2;
      places_.push_back({static_cast<int32_t>(l), i, reach});
      boxes.emplace_back(p - Point3::Constant(reach), p + Point3::Constant(reach));
    }
  }
  tree_ = BoxTree(boxes);
}

std::optional<RimTouch> RimTouches::FirstOn(const CreaseCurve& curve,
                                            const std::function<bool(const RimTouch&)>& is_end) const {
  std::vector<Point3> line;
  Eigen::AlignedBox3d box;
  for (int k = 0; k <= kCurvePieces; ++k) {
    line.push_back(curve.At(static_cast<double>(k) / kCurvePieces));
    box.extend(line.back());
  }
  std::optional<RimTouch> first;
  tree_.AnyMeeting(box, [&](int32_t number) {
    const auto& [loop, place, reach] = places_[number];
    if (first && std::pair(first->loop, first->place) < std::pair(loop, place)) return false;
    const auto [at, distance] = Nearest(line, loops_[loop].positions[place]);
    const RimTouch touch{loop, place, at};
    if (distance <= reach && !is_end(touch)) first = touch;
    return false;
  });
  return first;
}

}  // namespace tilemend
