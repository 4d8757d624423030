// A set of squares of a raster, in blocks.
#ifndef TILEMEND_WORKER_GROUND_SQUARE_BLOCKS_H_
#define TILEMEND_WORKER_GROUND_SQUARE_BLOCKS_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tilemend {

// Squares by column and row from 0. With a square its whole block is in the set, so that rows have few runs of them.
class SquareBlocks {
 public:
  static constexpr int32_t kSide = 8;  // squares

  // The empty set, of a raster of so many squares.
  SquareBlocks(int32_t cols, int32_t rows);
  static SquareBlocks All(int32_t cols, int32_t rows);

  // Precondition: a square of the raster.
  void Add(int32_t col, int32_t row) { AddBlock(IndexOf(col / kSide, row / kSide)); }

  bool empty() const { return std::find(has_.begin(), has_.end(), 1) == has_.end(); }

  // Blocks are numbered row by row.
  int32_t block_cols() const { return block_cols_; }
  int32_t block_rows() const { return block_rows_; }
  bool HasBlock(size_t block) const { return has_[block] != 0; }
  void AddBlock(size_t block) { has_[block] = 1; }

  // Those of another set for the same raster.
  void AddAll(const SquareBlocks& other) {
    for (size_t block = 0; block < has_.size(); ++block) has_[block] |= other.has_[block];
  }

  // All that is at most so many squares away along each axis, and maybe up to a block more. O(blocks).
  SquareBlocks GrownBy(int32_t squares) const;

  // Calls `use` with the row, the first column and the column behind the last one of each run of squares.
  void ForRuns(const auto& use) const {
    for (int32_t row = 0; row < rows_; ++row) {
      for (int32_t first = 0; first < block_cols_;) {
        int32_t end = first;
        while (end < block_cols_ && has_[IndexOf(end, row / kSide)] != 0) ++end;
        if (end > first) use(row, first * kSide, std::min(end * kSide, cols_));
        first = end + 1;
      }
    }
  }

 private:
  size_t IndexOf(int32_t block_col, int32_t block_row) const {
    return static_cast<size_t>(block_row) * block_cols_ + block_col;
  }

  int32_t cols_, rows_, block_cols_, block_rows_;
  std::vector<uint8_t> has_;  // of each block, row by row
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_GROUND_SQUARE_BLOCKS_H_
