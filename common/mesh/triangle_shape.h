// Area, normal and shape of single triangles.
#ifndef TILEMEND_COMMON_MESH_TRIANGLE_SHAPE_H_
#define TILEMEND_COMMON_MESH_TRIANGLE_SHAPE_H_

#include <Eigen/Geometry>
#include <cmath>
#include <span>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// All O(1), in plain double arithmetic: the same bits for the same corners in the same order, not in another.

// Along the normal of triangle a, b, c, twice as long as it has area. Zero if it has none.
inline Eigen::Vector3d TwiceVectorArea(const Point3& a, const Point3& b, const Point3& c) {
  return (b - a).cross(c - a);
}

inline Eigen::Vector3d TwiceVectorArea(std::span<const Point3> points, const Triangle& t) {
  return TwiceVectorArea(points[t[0]], points[t[1]], points[t[2]]);
}

inline Eigen::Vector3d TwiceVectorArea(const SpaceTriangle& t) { return TwiceVectorArea(t[0], t[1], t[2]); }

inline double TriangleArea(const Point3& a, const Point3& b, const Point3& c) {
  return TwiceVectorArea(a, b, c).norm() / 2;
}

// How good a triangle is: 2 * inradius / circumradius. 1 if equilateral, 0 if without area.
inline double TriangleQuality(const Point3& a, const Point3& b, const Point3& c) {
  const double la = (c - b).norm(), lb = (a - c).norm(), lc = (b - a).norm();
  const double area2 = TwiceVectorArea(a, b, c).norm();
  // r = A / s and R = a b c / (4 A), with A = area2 / 2 and s the half perimeter.
  const double divisor = (la + lb + lc) * la * lb * lc;
  return divisor > 0 ? 4 * area2 * area2 / divisor : 0;
}

// A smoother measure of the same, to be made as large as possible: 4 sqrt(3) area / sum of squared edges. It is 1 if
// equilateral, NaN if all corners are one. (Bank and Smith 1997; not negative in space, but with the sign of the area
// that is given to the second form.)
inline double TriangleShape(double twice_area, double squared_edges) {
  return 2 * std::sqrt(3.0) * twice_area / squared_edges;
}

inline double TriangleShape(const Point3& a, const Point3& b, const Point3& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a;
  return TriangleShape(ab.cross(ac).norm(), ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm());
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_TRIANGLE_SHAPE_H_
