#include "worker/ground/object_squares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tilemend {
namespace {

constexpr int32_t kSide = SquareBlocks::kSide;

// Above this share of the blocks an opening is made in all of them: the next one then need not make it again.
constexpr double kMostDoubtful = 0.2;

constexpr int16_t kNothing = INT16_MIN;  // below all heights

// A height for each block, row by row.
struct BlockHeights {
  int32_t cols, rows;
  std::vector<int16_t> of;

  // kNoSurface beyond the raster.
  int16_t At(int32_t col, int32_t row) const {
    if (col < 0 || row < 0 || col >= cols || row >= rows) return kNoSurface;
    return of[static_cast<size_t>(row) * cols + col];
  }
};

BlockHeights LowestOfBlocks(const StepRaster& surface, const SquareBlocks& blocks) {
  BlockHeights lowest{blocks.block_cols(), blocks.block_rows(), {}};
  lowest.of.assign(static_cast<size_t>(lowest.cols) * lowest.rows, kNoSurface);
  for (int32_t r = 0; r < surface.rows; ++r) {
    const int16_t* const from = surface.heights.data() + static_cast<size_t>(r) * surface.cols;
    int16_t* const to = lowest.of.data() + static_cast<size_t>(r / kSide) * lowest.cols;
    for (int32_t c = 0; c < surface.cols; ++c) to[c / kSide] = std::min(to[c / kSide], from[c]);
  }
  return lowest;
}

// The lowest of `count` heights that are `stride` apart, over at most `by` of them to either side.
void LowestAround(int32_t by, int32_t count, ptrdiff_t stride, const int16_t* from, int16_t* to) {
  for (int32_t i = 0; i < count; ++i) {
    int16_t lowest = kNoSurface;
    for (int32_t k = std::max(0, i - by); k <= std::min(count - 1, i + by); ++k) {
      lowest = std::min(lowest, from[k * stride]);
    }
    to[i * stride] = lowest;
  }
}

// The lowest over the square box of blocks up to `by` away.
BlockHeights LowestOfBoxes(const BlockHeights& lowest, int32_t by) {
  BlockHeights rows = lowest, boxes = lowest;
  for (int32_t r = 0; r < lowest.rows; ++r) {
    const size_t begin = static_cast<size_t>(r) * lowest.cols;
    LowestAround(by, lowest.cols, 1, lowest.of.data() + begin, rows.of.data() + begin);
  }
  for (int32_t c = 0; c < lowest.cols; ++c) {
    LowestAround(by, lowest.rows, lowest.cols, rows.of.data() + c, boxes.of.data() + c);
  }
  return boxes;
}

class Openings {
 public:
  Openings(const StepRaster& surface, const SquareBlocks& asked)
      : surface_(surface),
        asked_(asked),
        lowest_(LowestOfBlocks(surface, asked)),
        highest_{lowest_.cols, lowest_.rows, std::vector<int16_t>(lowest_.of.size(), kNothing)},
        is_object_(surface.heights.size(), 0),
        before_(surface),
        known_(asked) {}

  void Take(const OpeningStep& step) {
    const bool is_large = step.radius >= kSide;
    if (is_large && !is_highest_known_) TellHighest(asked_);
    is_highest_known_ = is_large;
    const SquareBlocks now = is_large ? Doubtful(step) : asked_;
    if (!now.empty()) Open(now, step);
    if (is_large) TellHighest(now);
    known_ = now;
    last_radius_ = step.radius;
  }

  std::vector<uint8_t> Objects() && { return std::move(is_object_); }

 private:
  size_t BeginOf(int32_t row) const { return static_cast<size_t>(row) * surface_.cols; }

  void Open(const SquareBlocks& now, const OpeningStep& step) {
    Recall(now);
    const StepRaster opened = OpenedByDisk(surface_, step.radius, now);
    now.ForRuns([&, most = static_cast<int32_t>(std::floor(step.most))](int32_t row, int32_t first, int32_t end) {
      const size_t begin = BeginOf(row);
      for (size_t i = begin + first; i < begin + end; ++i) {
        is_object_[i] |= static_cast<uint8_t>(before_.heights[i] - opened.heights[i] > most ? 1 : 0);
        before_.heights[i] = opened.heights[i];
      }
    });
  }

  // The blocks from which the opening may take more than `most` at a square that is no object yet.
  SquareBlocks Doubtful(const OpeningStep& step) const {
    const int32_t reach = (step.radius + kSide - 1) / kSide;  // in blocks
    const BlockHeights boxes = LowestOfBoxes(lowest_, reach);
    SquareBlocks doubtful(surface_.cols, surface_.rows);
    int64_t count = 0, of = 0;
    for (size_t block = 0; block < highest_.of.size(); ++block) {
      if (!asked_.HasBlock(block)) continue;
      ++of;
      if (highest_.of[block] == kNothing) continue;
      const auto col = static_cast<int32_t>(block) % boxes.cols, row = static_cast<int32_t>(block) / boxes.cols;
      if (highest_.of[block] - LeastOpening(boxes, reach, col, row) > step.most) {
        doubtful.AddBlock(block);
        ++count;
      }
    }
    return static_cast<double>(count) > kMostDoubtful * static_cast<double>(of) ? asked_ : doubtful;
  }

  // No opening in the block is lower: the highest of the boxes around it and to its four sides. If the middle block of
  // a box is there, each square of the block is in a disk inside the box, with its middle in the raster.
  static int16_t LeastOpening(const BlockHeights& boxes, int32_t reach, int32_t col, int32_t row) {
    constexpr std::array<std::array<int32_t, 2>, 5> kSides = {{{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    int16_t least = kNothing;
    for (const auto& [x, y] : kSides) {
      const int16_t lowest = boxes.At(col + x * reach, row + y * reach);
      if (lowest != kNoSurface) least = std::max(least, lowest);
    }
    return least;
  }

  // The last opening where it was not made.
  void Recall(const SquareBlocks& blocks) {
    if (last_radius_ == 0) return;  // the surface is there
    SquareBlocks missing(surface_.cols, surface_.rows);
    for (size_t block = 0; block < highest_.of.size(); ++block) {
      if (blocks.HasBlock(block) && !known_.HasBlock(block)) missing.AddBlock(block);
    }
    if (missing.empty()) return;
    const StepRaster opened = OpenedByDisk(surface_, last_radius_, missing);
    missing.ForRuns([&](int32_t row, int32_t first, int32_t end) {
      const int16_t* const from = opened.heights.data() + BeginOf(row);
      std::copy(from + first, from + end, before_.heights.data() + BeginOf(row) + first);
    });
  }

  // The highest surface that is no object of each of the blocks.
  void TellHighest(const SquareBlocks& blocks) {
    for (size_t block = 0; block < highest_.of.size(); ++block) {
      if (blocks.HasBlock(block)) highest_.of[block] = kNothing;
    }
    blocks.ForRuns([&](int32_t row, int32_t first, int32_t end) {
      int16_t* const highest = highest_.of.data() + static_cast<size_t>(row / kSide) * highest_.cols;
      for (int32_t begin = first; begin < end; begin += kSide) {
        const size_t from = BeginOf(row) + begin, to = BeginOf(row) + std::min(begin + kSide, end);
        int16_t most = kNothing;
        for (size_t i = from; i < to; ++i) {
          const int16_t ground = is_object_[i] == 0 ? surface_.heights[i] : kNoSurface;
          most = std::max(most, ground == kNoSurface ? kNothing : ground);
        }
        highest[begin / kSide] = std::max(highest[begin / kSide], most);
      }
    });
  }

  const StepRaster& surface_;
  const SquareBlocks& asked_;
  const BlockHeights lowest_;
  BlockHeights highest_;  // of squares with surface that are no objects; kNothing: there are none
  std::vector<uint8_t> is_object_;
  StepRaster before_;   // the last opening
  SquareBlocks known_;  // where it is that
  int32_t last_radius_ = 0;
  bool is_highest_known_ = false;
};

}  // namespace

std::vector<uint8_t> ObjectSquares(const StepRaster& surface, const SquareBlocks& asked,
                                   std::span<const OpeningStep> steps) {
  Openings openings(surface, asked);
  for (const OpeningStep& step : steps) openings.Take(step);
  return std::move(openings).Objects();
}

}  // namespace tilemend
