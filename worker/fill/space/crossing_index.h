// Triangles in space, by where they lie.
#ifndef TILEMEND_WORKER_FILL_SPACE_CROSSING_INDEX_H_
#define TILEMEND_WORKER_FILL_SPACE_CROSSING_INDEX_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/box_tree.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A growing set of triangles that tells what a new one crosses. Each addition costs O(log^2) over time: trees of equal
// size are built anew as one (Bentley and Saxe 1980).
class CrossingIndex {
 public:
  // Triangles without area are left out.
  explicit CrossingIndex(std::span<const SpaceTriangle> triangles);

  void Add(const SpaceTriangle& triangle);
  // Whether a triangle with area crosses one of them (TrianglesCross).
  bool IsCrossedBy(const SpaceTriangle& triangle) const;

  std::span<const SpaceTriangle> triangles() const { return triangles_; }

 private:
  struct Level {
    int32_t first;  // of triangles_
    BoxTree tree;
  };

  void Plant(int32_t first);

  std::vector<SpaceTriangle> triangles_;
  std::vector<Level> levels_;  // one after the other, each at most half as large as the one before
  int32_t planted_ = 0;        // of triangles_; the rest is in no tree yet
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_CROSSING_INDEX_H_
