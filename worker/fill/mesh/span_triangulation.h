// The order in which dynamic programming triangulates a loop, and the way back (Barequet and Sharir 1995).
#ifndef TILEMEND_WORKER_FILL_MESH_SPAN_TRIANGULATION_H_
#define TILEMEND_WORKER_FILL_MESH_SPAN_TRIANGULATION_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Calls solve(i, k) for all 0 <= i, i + 2 <= k < n, shorter spans first. Each call settles apex(i, k), the vertex
// between the two whose triangle closes what lies from i to k. It is below 0 if nothing does. Gives the triangles of
// the whole loop of n >= 3 vertices; none if it cannot be closed. O(n^2) calls.
template <class Solve, class Apex>
std::vector<Triangle> TriangulateSpans(int32_t n, const Solve& solve, const Apex& apex) {
  for (int32_t span = 2; span < n; ++span) {
    for (int32_t i = 0; i + span < n; ++i) solve(i, i + span);
  }
  std::vector<Triangle> triangles;
  if (apex(0, n - 1) < 0) return triangles;
  std::vector<std::pair<int32_t, int32_t>> open = {{0, n - 1}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k - i < 2) continue;
    const int32_t j = apex(i, k);
    triangles.push_back({i, j, k});
    open.emplace_back(i, j);
    open.emplace_back(j, k);
  }
  return triangles;
}

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_MESH_SPAN_TRIANGULATION_H_
