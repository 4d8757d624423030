#include "worker/fill/space/rim_junctions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "common/mesh/box_tree.h"
#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kOnEdge = 0x1p-12;  // of the edge's length

}  // namespace

bool HasJunction(const LocalHole& hole) {
  const auto at = [&](int32_t v) -> const Point3& { return hole.positions[v]; };
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const RegionSegment& s : hole.segments) {
    Eigen::AlignedBox3d box = Eigen::AlignedBox3d(at(s.from)).extend(at(s.to));
    const Point3 margin = Point3::Constant(kOnEdge * (at(s.to) - at(s.from)).norm());
    boxes.emplace_back(box.min() - margin, box.max() + margin);
  }
  const BoxTree tree(boxes);
  return std::ranges::any_of(hole.segments, [&](const RegionSegment& segment) {
    const Point3& p = at(segment.from);
    return tree.AnyMeeting(Eigen::AlignedBox3d(p), [&](int32_t i) {
      const Point3 &a = at(hole.segments[i].from), &b = at(hole.segments[i].to);
      return p != a && p != b && DistanceToSegment(p, a, b) <= kOnEdge * (b - a).norm();
    });
  });
}

}  // namespace tilemend
