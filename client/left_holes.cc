#include "client/left_holes.h"

#include <algorithm>

#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kLeftReach = 1;  // metres around the boundary of a hole that was left

Eigen::AlignedBox3d WidenedBox(const Point2& lo, const Point2& hi, double reach) {
  return {Point3(lo.x() - reach, lo.y() - reach, 0), Point3(hi.x() + reach, hi.y() + reach, 0)};
}

}  // namespace

LeftHoles::LeftHoles(std::span<const ReportedOutput::Left> left) {
  for (const ReportedOutput::Left& hole : left) {
    const Point2 at = hole.at.head<2>();
    if (hole.rim.empty()) parts_.push_back({at, at, hole.reach + kLeftReach});
    for (const std::vector<Point2>& ring : hole.rim) {
      for (size_t k = 1; k < ring.size(); ++k) parts_.push_back({ring[k - 1], ring[k], kLeftReach});
    }
    if (hole.reaches_border && !hole.box.isEmpty()) beyond_.push_back({hole.cell, hole.box});
  }
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Part& part : parts_) {
    boxes.push_back(WidenedBox(part.a.cwiseMin(part.b), part.a.cwiseMax(part.b), part.reach));
  }
  part_tree_ = BoxTree(boxes);
  boxes.clear();
  for (const Beyond& hole : beyond_) boxes.push_back(WidenedBox(hole.box.min(), hole.box.max(), kLeftReach));
  beyond_tree_ = BoxTree(boxes);
}

bool LeftHoles::AreAt(const Point2& p, std::span<const CellId> beside) const {
  const Eigen::AlignedBox3d at(Point3(p.x(), p.y(), 0));
  const bool is_near = part_tree_.AnyMeeting(
      at, [&](int32_t i) { return DistanceToSegment(p, parts_[i].a, parts_[i].b) <= parts_[i].reach; });
  if (is_near || beside.empty()) return is_near;
  return beyond_tree_.AnyMeeting(at, [&](int32_t i) {
    return std::ranges::find(beside, beyond_[i].cell) != beside.end() &&
           beyond_[i].box.exteriorDistance(p) <= kLeftReach;
  });
}

}  // namespace tilemend
