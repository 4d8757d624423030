#include "common/mesh/polygon_tree.h"

#include <algorithm>

namespace tilemend {

Eigen::AlignedBox3d FlatBoxOf(const PlanePolygon& polygon) {
  Eigen::AlignedBox3d box;
  for (const std::vector<Point2>& ring : polygon.rings) {
    for (const Point2& p : ring) box.extend(Eigen::Vector3d(p.x(), p.y(), 0));
  }
  return box;
}

std::vector<int32_t> PolygonTree::Meeting(const Point2& lo, const Point2& hi) const {
  std::vector<int32_t> found;
  ForMeeting(lo, hi, [&](int32_t i) { found.push_back(i); });
  std::ranges::sort(found);
  return found;
}

}  // namespace tilemend
