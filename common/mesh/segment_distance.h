// The distance from a point to a segment.
#ifndef TILEMEND_COMMON_MESH_SEGMENT_DISTANCE_H_
#define TILEMEND_COMMON_MESH_SEGMENT_DISTANCE_H_

#include <Eigen/Core>
#include <algorithm>

namespace tilemend {

// From p to the nearest point of ab, in the plane or in space; to a if a and b are one point. Not exact.
template <typename Point>
double DistanceToSegment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
  return (p - a - t * d).norm();
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_SEGMENT_DISTANCE_H_
