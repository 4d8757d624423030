// The wanted edge length anywhere in the plane: it grows away from points that have one.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_GROWN_SIZES_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_GROWN_SIZES_H_

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A tree of boxes over points. A search passes over each box whose points are too far away or too large to count, so
// that its cost does not depend on how close together the points are.
class GrownSizes {
 public:
  struct Point {
    Point2 position{0, 0};
    double size = 0;
  };

  // Cost: O(n log n); memory: 40 to 60 bytes a point.
  explicit GrownSizes(std::vector<Point> points);

  // The minimum over the points v of size(v) + growth * |p - v|, at most `limit`, bit for bit as a search over all
  // points has it. Precondition: growth is not negative. Cost: usually O(log n) for points along a curve.
  double At(const Point2& p, double growth, double limit) const;

 private:
  // Of points [begin, end). Its children: the next node, and `other`; 0: it has none.
  struct Node {
    Eigen::AlignedBox2d box;
    double least = 0;  // size
    size_t begin = 0, end = 0;
    size_t other = 0;
  };

  size_t Build(size_t begin, size_t end);

  std::vector<Point> points_;
  std::vector<Node> nodes_;  // the root first
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_GROWN_SIZES_H_
