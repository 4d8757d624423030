// Lists of numbers, one list for each vertex: corners, neighbours, triangles around it.
#ifndef TILEMEND_COMMON_MESH_VERTEX_LISTS_H_
#define TILEMEND_COMMON_MESH_VERTEX_LISTS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// All lists in two arrays: 4 bytes an entry and 4 bytes a vertex. Entries keep the order in which they are given, so
// that a sum over a list has the same bits each time.
class VertexLists {
 public:
  // `for_each(use)` calls use(vertex, entry) for all entries. It runs twice, to count and to store, and must do the
  // same both times. Precondition: vertices are in [0, vertex_count). Linear.
  template <typename ForEach>
  VertexLists(size_t vertex_count, const ForEach& for_each) : first_(vertex_count + 2, 0) {
    for_each([&](int32_t vertex, int32_t) { ++first_[static_cast<size_t>(vertex) + 2]; });
    for (size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
    entries_.resize(static_cast<size_t>(first_.back()));
    // Each beginning moves to the end of its list, where the next one begins.
    for_each([&](int32_t vertex, int32_t entry) { entries_[first_[static_cast<size_t>(vertex) + 1]++] = entry; });
  }

  std::span<const int32_t> Of(int32_t vertex) const {
    const auto v = static_cast<size_t>(vertex);
    return {entries_.data() + first_[v], entries_.data() + first_[v + 1]};
  }

 private:
  std::vector<int32_t> first_, entries_;
};

// For each vertex its corners in the order of the triangles. Corner 4 t + k is corner k of triangle t, k < 3.
inline VertexLists CornersAt(std::span<const Triangle> triangles, size_t vertex_count) {
  return VertexLists(vertex_count, [&](const auto& use) {
    int32_t corner = 0;
    for (const Triangle& t : triangles) {
      for (int k = 0; k < 3; ++k) use(t[k], corner + k);
      corner += 4;
    }
  });
}

// For each vertex the ends of the triangles' edges that leave it, in the order of the triangles.
inline VertexLists EdgeEndsFrom(std::span<const Triangle> triangles, size_t vertex_count) {
  return VertexLists(vertex_count, [&](const auto& use) {
    for (const Triangle& t : triangles) {
      for (int k = 0; k < 3; ++k) use(t[k], t[(k + 1) % 3]);
    }
  });
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_VERTEX_LISTS_H_
