// The tree of the regions that a raster of heights has below each level.
#ifndef TILEMEND_WORKER_PROPOSE_HEIGHT_TREE_H_
#define TILEMEND_WORKER_PROPOSE_HEIGHT_TREE_H_

#include <cstdint>
#include <vector>

namespace tilemend {

// Squares, row by row, with their heights in whole steps; kWall takes no part.
struct SteppedHeights {
  static constexpr int32_t kWall = INT32_MAX;
  int32_t cols = 0, rows = 0;
  std::vector<int32_t> steps;
};

inline constexpr int32_t kDeepSteps = 5;

// A region: squares at or below a level that touch at sides or corners. It has a node at each level at which it grows.
struct HeightNode {
  int32_t level = 0;    // steps
  int64_t area = 0;     // squares
  int64_t deep = 0;     // of these, how many lie `band` or more below the level
  int32_t parent = -1;  // the node that it is part of at the next level at which it grows; -1: none
  int32_t square = 0;   // one of its squares
};

// All nodes, by level; a parent comes after its children. Cost O(n log n) for n squares. (The component tree of Najman
// and Couprie 2006, with Salembier's order by levels.)
std::vector<HeightNode> HeightTreeOf(const SteppedHeights& heights);

// The squares at or below a level that are together with one of them, in ascending order. Cost O(n log n) for n of
// them.
std::vector<int32_t> SquaresBelow(const SteppedHeights& heights, int32_t square, int32_t level);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PROPOSE_HEIGHT_TREE_H_
