#include "common/mesh/triangle_copies.h"

#include <algorithm>
#include <set>

namespace tilemend {

std::optional<std::vector<Triangle>> WithoutCopies(const MeshView& mesh) {
  std::vector<Triangle> once;
  std::set<Triangle> seen;
  for (const Triangle& t : mesh.triangles) {
    Triangle corners = t;
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    if (seen.insert(corners).second) once.push_back(t);
  }
  return once.size() < mesh.triangles.size() ? std::optional(std::move(once)) : std::nullopt;
}

}  // namespace tilemend
