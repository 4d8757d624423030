#include "coordinator/check/mesh_outline.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/mesh/position_index.h"

namespace tilemend {

bool HasBoundary(const TriMesh& mesh) {
  PositionIndex index;
  std::vector<uint64_t> number;
  number.reserve(mesh.points.size());
  for (const Point3& p : mesh.points) number.push_back(static_cast<uint64_t>(index.Insert(p)));
  std::vector<uint64_t> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const uint64_t n[3] = {number[t[0]], number[t[1]], number[t[2]]};
    if (n[0] == n[1] || n[1] == n[2] || n[0] == n[2]) continue;
    for (int k = 0; k < 3; ++k) {
      const uint64_t a = n[k], b = n[(k + 1) % 3];
      edges.push_back(std::min(a, b) << 32 | std::max(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (size_t i = 0; i < edges.size();) {
    size_t j = i;
    while (j < edges.size() && edges[j] == edges[i]) ++j;
    if (j - i == 1) return true;
    i = j;
  }
  return false;
}

}  // namespace tilemend
