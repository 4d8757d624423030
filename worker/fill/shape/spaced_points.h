// Points that keep their sizes apart.
#ifndef TILEMEND_WORKER_FILL_SHAPE_SPACED_POINTS_H_
#define TILEMEND_WORKER_FILL_SHAPE_SPACED_POINTS_H_

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Points in cells as large as their sizes. Sizes vary smoothly: points of more than twice or less than half the size
// are not looked at.
class SpacedPoints {
 public:
  // Whether a point is nearer than the lesser of its size and this one, over sqrt 2. O(1) where points keep apart.
  bool HasNear(const Point3& p, double size) const;
  void Add(const Point3& p, double size);
  void Clear() { cells_.clear(); }

 private:
  static uint64_t KeyOf(const Point3& p, int level, const Eigen::Vector3d& step);

  std::unordered_map<uint64_t, std::vector<std::pair<Point3, double>>> cells_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SHAPE_SPACED_POINTS_H_
