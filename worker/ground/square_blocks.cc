#include "worker/ground/square_blocks.h"

namespace tilemend {
namespace {

// Sets what is at most `by` before or behind a value that is set, of `count` values that are `stride` apart.
void GrowLine(int32_t by, int32_t count, ptrdiff_t stride, const uint8_t* from, uint8_t* to) {
  int32_t set_until = -1;
  for (int32_t i = 0; i < count; ++i) {
    if (from[i * stride] != 0) set_until = i + by;
    if (i <= set_until) to[i * stride] = 1;
  }
  int32_t set_from = count;
  for (int32_t i = count - 1; i >= 0; --i) {
    if (from[i * stride] != 0) set_from = i - by;
    if (i >= set_from) to[i * stride] = 1;
  }
}

}  // namespace

SquareBlocks::SquareBlocks(int32_t cols, int32_t rows)
    : cols_(cols),
      rows_(rows),
      block_cols_((cols + kSide - 1) / kSide),
      block_rows_((rows + kSide - 1) / kSide),
      has_(static_cast<size_t>(block_cols_) * block_rows_, 0) {}

SquareBlocks SquareBlocks::All(int32_t cols, int32_t rows) {
  SquareBlocks all(cols, rows);
  std::fill(all.has_.begin(), all.has_.end(), uint8_t{1});
  return all;
}

SquareBlocks SquareBlocks::GrownBy(int32_t squares) const {
  const int32_t by = (squares + kSide - 1) / kSide;
  SquareBlocks wide = *this;
  for (int32_t r = 0; r < block_rows_; ++r) {
    GrowLine(by, block_cols_, 1, has_.data() + IndexOf(0, r), wide.has_.data() + IndexOf(0, r));
  }
  SquareBlocks grown = wide;
  for (int32_t c = 0; c < block_cols_; ++c) {
    GrowLine(by, block_rows_, block_cols_, wide.has_.data() + c, grown.has_.data() + c);
  }
  return grown;
}

}  // namespace tilemend
