#include "worker/fill/shape/spaced_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tilemend {

// Cells of a level are twice as large as the power of two below the size, so that what is near a point is in the cell
// of the point or one beside it. Cells that share a key only cost time.
uint64_t SpacedPoints::KeyOf(const Point3& p, int level, const Eigen::Vector3d& step) {
  uint64_t key = static_cast<uint64_t>(static_cast<int64_t>(level));
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<int64_t>(std::floor(std::ldexp(p[axis], -level - 1)) + step[axis]);
    key = (key ^ static_cast<uint64_t>(cell)) * 0x9e3779b97f4a7c15ULL;
    key ^= key >> 29;
  }
  return key;
}

bool SpacedPoints::HasNear(const Point3& p, double size) const {
  const int level = std::ilogb(size);
  for (int l = level - 1; l <= level + 1; ++l) {
    for (int k = 0; k < 27; ++k) {
      const int x = k % 3 - 1, y = k / 3 % 3 - 1, z = k / 9 - 1;
      const auto found = cells_.find(KeyOf(p, l, Point3(x, y, z)));
      if (found == cells_.end()) continue;
      for (const auto& [other, other_size] : found->second) {
        if (std::numbers::sqrt2 * (other - p).norm() < std::min(size, other_size)) return true;
      }
    }
  }
  return false;
}

void SpacedPoints::Add(const Point3& p, double size) {
  cells_[KeyOf(p, std::ilogb(size), Eigen::Vector3d::Zero())].emplace_back(p, size);
}

}  // namespace tilemend
