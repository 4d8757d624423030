#include "worker/fill/space/rim_junctions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "common/mesh/box_tree.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {

bool HasJunction(const LocalHole& hole) {
  const auto at = [&](int32_t v) -> const Point3& { return hole.positions[v]; };
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const RegionSegment& s : hole.segments) boxes.emplace_back(at(s.from)).extend(at(s.to));
  const BoxTree tree(boxes);
  return std::ranges::any_of(hole.segments, [&](const RegionSegment& segment) {
    const Point3& p = at(segment.from);
    return tree.AnyMeeting(Eigen::AlignedBox3d(p), [&](int32_t i) {
      const Point3 &a = at(hole.segments[i].from), &b = at(hole.segments[i].to);
      return p != a && p != b && !HasArea({p, a, b});
    });
  });
}

}  // namespace tilemend
