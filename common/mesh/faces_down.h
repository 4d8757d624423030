// Whether triangles of height fields are folded.
#ifndef TILEMEND_COMMON_MESH_FACES_DOWN_H_
#define TILEMEND_COMMON_MESH_FACES_DOWN_H_

#include <algorithm>

#include "common/mesh/triangle_shape.h"

namespace tilemend {

// Whether the triangle a, b, c faces down by more than rounding of its corners explains: that turns upright and very
// narrow triangles alone. Their area from above is small beside the square of their longest edge. O(1).
inline bool FacesDown(const Point3& a, const Point3& b, const Point3& c) {
  constexpr double kLeastDown = 0.01;  // twice the area from above, as a share of the longest edge squared
  const double longest = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
  return TwiceVectorArea(a, b, c).z() < -kLeastDown * longest;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_FACES_DOWN_H_
