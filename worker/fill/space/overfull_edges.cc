#include "worker/fill/space/overfull_edges.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using Edge = std::pair<int32_t, int32_t>;

std::vector<Edge> OverfullEdges(const LocalHole& hole, const LocalPatch& patch) {
  std::set<Edge> beside_surface;  // as they run in triangles
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[k], b = t[(k + 1) % 3];
      if (a < hole.size() && b < hole.size() && hole.TrianglesBeside(a, b) > 0) beside_surface.insert({a, b});
    }
  }
  std::vector<Edge> edges;
  for (const auto& [a, b] : beside_surface) {
    if (a < b && beside_surface.contains({b, a})) edges.emplace_back(a, b);
  }
  return edges;
}

void Divide(const LocalHole& hole, const Edge& edge, LocalPatch& patch) {
  const auto [a, b] = edge;
  const int32_t middle = hole.size() + static_cast<int32_t>(patch.new_points.size());
  patch.new_points.push_back(hole.Storable((hole.positions[a] + hole.positions[b]) / 2));
  const size_t count = patch.triangles.size();
  for (size_t t = 0; t < count; ++t) {
    Triangle& first = patch.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const int32_t from = first[k], to = first[(k + 1) % 3];
      if (std::min(from, to) != a || std::max(from, to) != b) continue;
      Triangle second = first;
      first[(k + 1) % 3] = middle;
      second[k] = middle;
      patch.triangles.push_back(second);
      break;
    }
  }
}

}  // namespace

void DivideOverfullEdges(const LocalHole& hole, LocalPatch& patch) {
  for (const Edge& edge : OverfullEdges(hole, patch)) Divide(hole, edge, patch);
}

}  // namespace tilemend
