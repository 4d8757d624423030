// Heights of a mesh, for tests.
#ifndef TILEMEND_TESTS_SUPPORT_TOP_AT_H_
#define TILEMEND_TESTS_SUPPORT_TOP_AT_H_

#include <cmath>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The height of the highest surface of a mesh over p; NaN where there is none.
inline double TopAt(const TriMesh& mesh, const Point2& p) {
  double top = std::nan("");
  for (const Triangle& t : mesh.triangles) {
    const Point3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Point2 u = (b - a).head<2>(), v = (c - a).head<2>(), w = p - a.head<2>();
    const double area = u.x() * v.y() - u.y() * v.x();
    if (area == 0) continue;
    const double s = (w.x() * v.y() - w.y() * v.x()) / area, r = (u.x() * w.y() - u.y() * w.x()) / area;
    if (s < 0 || r < 0 || s + r > 1) continue;
    top = std::fmax(top, a.z() + s * (b.z() - a.z()) + r * (c.z() - a.z()));
  }
  return top;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_TOP_AT_H_
