#include "worker/fill/space/crossing_index.h"

#include <algorithm>
#include <cmath>

#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

using Eigen::AlignedBox3d;

// Fewer are looked at one by one.
constexpr int32_t kLeastTree = 32;
// Of the coordinates: rounding is far less.
constexpr double kSlack = 1e-9;

}  // namespace

CrossingIndex::CrossingIndex(std::span<const SpaceTriangle> triangles) {
  for (const SpaceTriangle& t : triangles) {
    if (HasArea(t)) triangles_.push_back(t);
  }
  Plant(0);
}

void CrossingIndex::Add(const SpaceTriangle& triangle) {
  triangles_.push_back(triangle);
  const auto count = static_cast<int32_t>(triangles_.size());
  if (count - planted_ < kLeastTree) return;
  int32_t first = planted_;
  while (!levels_.empty() && first - levels_.back().first < 2 * (count - first)) {
    first = levels_.back().first;
    levels_.pop_back();
  }
  Plant(first);
}

void CrossingIndex::Plant(int32_t first) {
  std::vector<AlignedBox3d> boxes;
  for (size_t i = static_cast<size_t>(first); i < triangles_.size(); ++i) boxes.push_back(BoxOf(triangles_[i]));
  levels_.push_back({first, BoxTree(boxes)});
  planted_ = static_cast<int32_t>(triangles_.size());
}

bool CrossingIndex::IsCrossedBy(const SpaceTriangle& triangle) const {
  if (triangles_.empty()) return false;
  const AlignedBox3d extent = BoxOf(triangle);
  const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
  const double slack = kSlack * (extent.min().cwiseAbs() + extent.max().cwiseAbs()).sum();
  // Large triangles have much within their extent, but little at their plane.
  const auto meets = [&](const AlignedBox3d& box) {
    if (!box.intersects(extent)) return false;
    const double height = normal.dot(box.center() - triangle[0]), reach = normal.cwiseAbs().dot(box.sizes()) / 2;
    return std::abs(height) <= (1 + kSlack) * reach + slack;
  };
  for (const Level& level : levels_) {
    const auto crosses = [&](int32_t i) { return TrianglesCross(triangle, triangles_[level.first + i]); };
    if (level.tree.AnyWhere(meets, crosses)) return true;
  }
  return std::any_of(triangles_.begin() + planted_, triangles_.end(),
                     [&](const SpaceTriangle& t) { return meets(BoxOf(t)) && TrianglesCross(triangle, t); });
}

}  // namespace tilemend
