// Sets of squares of a raster.
#ifndef TILEMEND_WORKER_PROPOSE_SQUARE_SET_H_
#define TILEMEND_WORKER_PROPOSE_SQUARE_SET_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tilemend {

// Squares of a window of a raster, row by row.
struct SquareSet {
  int32_t col = 0, row = 0;    // of the first square of the window
  int32_t cols = 0, rows = 0;  // of the window
  std::vector<bool> has;

  bool Has(int32_t at_col, int32_t at_row) const {
    const int32_t c = at_col - col, r = at_row - row;
    return c >= 0 && r >= 0 && c < cols && r < rows && has[static_cast<size_t>(r) * cols + c];
  }
};

struct Square {
  int32_t col = 0, row = 0;
  bool operator==(const Square&) const = default;
};

// The set of some squares, in a window with one square more on each side.
SquareSet SetOf(const std::vector<Square>& squares);

int64_t CountOf(const SquareSet& set);

// With the squares that the set encloses, where they are at most `most` together. Here and below: cost O(squares of the
// window), of which those at the edge are not of the set.
SquareSet WithSmallIslands(const SquareSet& set, int64_t most);

// The squares that touch the set at a side or a corner and are not of it, row by row.
std::vector<Square> RimOf(const SquareSet& set);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PROPOSE_SQUARE_SET_H_
