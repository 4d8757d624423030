// Heights of a mesh, seen from above.
#ifndef TILEMEND_TESTS_SUPPORT_HEIGHT_OVER_H_
#define TILEMEND_TESTS_SUPPORT_HEIGHT_OVER_H_

#include <algorithm>
#include <cstddef>
#include <optional>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The height of a mesh over a place, of its triangles from `first` on: the first of them there.
inline std::optional<double> HeightOver(const TriMesh& mesh, size_t first, const Point2& p) {
  for (size_t t = first; t < mesh.triangles.size(); ++t) {
    const auto& [i, j, k] = mesh.triangles[t];
    const Point3 &a = mesh.points[i], &b = mesh.points[j], &c = mesh.points[k];
    const auto turn = [](const Point2& u, const Point2& v, const Point2& w) {
      return (v.x() - u.x()) * (w.y() - u.y()) - (v.y() - u.y()) * (w.x() - u.x());
    };
    const Point2 u = a.head<2>(), v = b.head<2>(), w = c.head<2>();
    const double whole = turn(u, v, w), at_a = turn(v, w, p) / whole, at_b = turn(w, u, p) / whole;
    if (!(std::min({at_a, at_b, 1 - at_a - at_b}) >= -1e-9)) continue;  // or without area
    return at_a * a.z() + at_b * b.z() + (1 - at_a - at_b) * c.z();
  }
  return std::nullopt;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_HEIGHT_OVER_H_
