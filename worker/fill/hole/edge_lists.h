// The directed edges of triangles, by the vertex that they leave.
#ifndef TILEMEND_WORKER_FILL_HOLE_EDGE_LISTS_H_
#define TILEMEND_WORKER_FILL_HOLE_EDGE_LISTS_H_

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// For each vertex the ends of its outgoing edges, in the order of the triangles: one array, 4 bytes an edge. Building
// it is linear; looking up an edge takes as many steps as its vertex has edges.
class EdgeLists {
 public:
  // Precondition: corners are in [0, vertex_count).
  EdgeLists(std::span<const Triangle> triangles, size_t vertex_count)
      : first_(vertex_count + 1, 0), end_(3 * triangles.size()) {
    for (const Triangle& t : triangles) {
      for (const int32_t v : t) ++first_[static_cast<size_t>(v) + 1];
    }
    for (size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    std::vector<int32_t> next(first_.begin(), first_.end() - 1);
    for (const Triangle& t : triangles) {
      for (int k = 0; k < 3; ++k) end_[next[t[k]]++] = t[(k + 1) % 3];
    }
  }

  std::span<const int32_t> From(int32_t v) const {
    return std::span(end_).subspan(first_[v], static_cast<size_t>(first_[v + 1] - first_[v]));
  }

  int Count(int32_t from, int32_t to) const {
    const std::span<const int32_t> ends = From(from);
    return static_cast<int>(std::count(ends.begin(), ends.end(), to));
  }

 private:
  std::vector<int32_t> first_, end_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_EDGE_LISTS_H_
