// One triangle of linear finite elements.
#ifndef TILEMEND_WORKER_FILL_SURFACE_PLATE_ELEMENT_H_
#define TILEMEND_WORKER_FILL_SURFACE_PLATE_ELEMENT_H_

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Stiffness of one triangle and its area, in the plane or in space.
struct PlateElement {
  std::array<double, 3> half_cotangent{};  // of the angle at each corner
  double area = 0;
};

inline double TwiceArea(const Point2& u, const Point2& v) { return std::abs(u.x() * v.y() - u.y() * v.x()); }
inline double TwiceArea(const Point3& u, const Point3& v) { return u.cross(v).norm(); }

// Needles are given the area of a triangle with an angle of that sine, so that they cannot outweigh everything else.
template <class Point>
PlateElement PlateElementOf(const std::array<Point, 3>& p) {
  constexpr double kLeastSine = 1e-3;
  PlateElement e;
  double longest2 = 0;
  for (int k = 0; k < 3; ++k) longest2 = std::max(longest2, (p[(k + 1) % 3] - p[k]).squaredNorm());
  const Point u = p[1] - p[0], v = p[2] - p[0];
  const double area2 = std::max(TwiceArea(u, v), kLeastSine * longest2);
  e.area = area2 / 2;
  for (int k = 0; k < 3; ++k) {
    const Point s = p[(k + 1) % 3] - p[k], t = p[(k + 2) % 3] - p[k];
    e.half_cotangent[k] = s.dot(t) / area2 / 2;
  }
  return e;
}

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_PLATE_ELEMENT_H_
