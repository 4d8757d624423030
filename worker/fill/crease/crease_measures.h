// What the search for creases measures with.
#ifndef TILEMEND_WORKER_FILL_CREASE_CREASE_MEASURES_H_
#define TILEMEND_WORKER_FILL_CREASE_CREASE_MEASURES_H_

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace tilemend::internal {

inline constexpr double kDegree = std::numbers::pi / 180;
// A vertex is on a crease if it is this close to both planes, in edge lengths.
inline constexpr double kOnCrease = 0.25;

inline double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The members of a cyclic sequence of n by any index.
inline int32_t Wrap(int32_t i, int32_t n) { return ((i % n) + n) % n; }

}  // namespace tilemend::internal

#endif  // TILEMEND_WORKER_FILL_CREASE_CREASE_MEASURES_H_
