// Finds polygons by where they lie.
#ifndef TILEMEND_COMMON_MESH_POLYGON_TREE_H_
#define TILEMEND_COMMON_MESH_POLYGON_TREE_H_

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/mesh/box_tree.h"
#include "common/mesh/plane_polygon.h"

namespace tilemend {

// The bounds of a polygon, at height 0; empty for an empty one.
Eigen::AlignedBox3d FlatBoxOf(const PlanePolygon& polygon);

// The bounds of polygons in a BoxTree. Cost O(positions + n log n) for n polygons; safe from any thread once built.
class PolygonTree {
 public:
  PolygonTree() = default;  // of none
  // Of the polygons polygon_of(i), for i from 0 to count - 1.
  template <typename PolygonOf>
  PolygonTree(size_t count, const PolygonOf& polygon_of) {
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(count);
    for (size_t i = 0; i < count; ++i) boxes.push_back(FlatBoxOf(polygon_of(i)));
    tree_ = BoxTree(boxes);
  }

  // Calls visit(i) for each polygon whose bounds meet the box from `lo` to `hi`, or touch it, in no order.
  template <typename Visit>
  void ForMeeting(const Point2& lo, const Point2& hi, const Visit& visit) const {
    const Eigen::AlignedBox3d box(Eigen::Vector3d(lo.x(), lo.y(), 0), Eigen::Vector3d(hi.x(), hi.y(), 0));
    tree_.AnyMeeting(box, [&](int32_t i) {
      visit(i);
      return false;
    });
  }

  // Those polygons, rising.
  std::vector<int32_t> Meeting(const Point2& lo, const Point2& hi) const;

 private:
  BoxTree tree_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_POLYGON_TREE_H_
