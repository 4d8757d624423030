// The height of a triangle over a point.
#ifndef TILEMEND_WORKER_FILL_SPACE_HEIGHT_OVER_H_
#define TILEMEND_WORKER_FILL_SPACE_HEIGHT_OVER_H_

#include <limits>

#include "common/mesh/triangle_shape.h"

namespace tilemend {

// Of the triangle over p, along the vertical; infinity where it lies neither over nor under p.
inline double HeightOver(const SpaceTriangle& t, const Point3& p) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto normal = TwiceVectorArea(t);
  if (normal.z() == 0) return kNone;
  for (int k = 0; k < 3; ++k) {
    const Point2 side = (t[(k + 1) % 3] - t[k]).head<2>(), to = (p - t[k]).head<2>();
    if ((side.x() * to.y() - side.y() * to.x()) * normal.z() < 0) return kNone;
  }
  return normal.dot(t[0] - p) / normal.z();
}

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_HEIGHT_OVER_H_
