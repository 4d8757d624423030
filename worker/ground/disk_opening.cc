#include "worker/ground/disk_opening.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <memory>

namespace tilemend {
namespace {

// Half the length of each row of a disk, from its middle row on.
std::vector<int32_t> HalfWidths(int32_t radius) {
  std::vector<int32_t> widths;
  for (int32_t dy = 0; dy <= radius; ++dy) {
    widths.push_back(static_cast<int32_t>(std::sqrt(static_cast<double>(radius) * radius - dy * dy)));
  }
  return widths;
}

// The lower of each two values.
void LowerOf(const int16_t* a, const int16_t* b, int32_t count, int16_t* __restrict lower) {
  for (int32_t i = 0; i < count; ++i) lower[i] = std::min(a[i], b[i]);
}

// Rows with `radius` squares more on both sides, and their minima over 2^k squares from each square on. Only the rows
// that one row of disks needs are there at a time, so that they stay in a processor's cache.
class RunMinima {
 public:
  RunMinima(const StepRaster& raster, int32_t radius)
      : raster_(raster), radius_(radius), width_(raster.cols + 2 * radius) {
    const auto levels = static_cast<size_t>(std::bit_width(static_cast<uint32_t>(2 * radius + 1)));
    const size_t size = static_cast<size_t>(width_) * (2 * radius + 1);
    for (size_t k = 0; k < levels; ++k) rows_.push_back(std::make_unique_for_overwrite<int16_t[]>(size));
    std::fill_n(rows_[0].get(), size, kNoSurface);
  }

  // For calls of Lower with rows at most `radius` away. Rows are asked for from the lowest one on.
  void MoveTo(int32_t row) {
    next_ = std::max(next_, row - radius_);
    for (; next_ <= std::min(row + radius_, raster_.rows - 1); ++next_) Prepare(next_);
  }

  struct Columns {
    int32_t first, end;
  };

  // Lowers the value of each column to the minimum of rows r and s from `half` squares before it to as many behind it.
  // One pass for both, as that takes less than half the time of a pass for each run.
  void Lower(int32_t r, int32_t s, int32_t half, Columns columns, int16_t* __restrict values) const {
    const auto k = static_cast<size_t>(std::bit_width(static_cast<uint32_t>(2 * half + 1)) - 1);
    const ptrdiff_t to_second = 2 * half + 1 - (1 << k);  // from the run that begins `half` squares before
    const int16_t* of_r = Run(k, r) + columns.first - half;
    const int16_t* of_s = Run(k, s) + columns.first - half;
    for (int32_t i = 0; i < columns.end - columns.first; ++i) {
      const int16_t in_r = std::min(of_r[i], of_r[i + to_second]), in_s = std::min(of_s[i], of_s[i + to_second]);
      values[i] = std::min(values[i], std::min(in_r, in_s));
    }
  }

 private:
  void Prepare(int32_t r) {
    const auto* from = raster_.heights.data() + static_cast<size_t>(r) * raster_.cols;
    std::copy(from, from + raster_.cols, Row(0, r) + radius_);
    for (size_t k = 1; k < rows_.size(); ++k) {
      const int32_t half = 1 << (k - 1);
      LowerOf(Row(k - 1, r), Row(k - 1, r) + half, width_ - half, Row(k, r));
      std::copy(Row(k - 1, r) + width_ - half, Row(k - 1, r) + width_, Row(k, r) + width_ - half);
    }
  }

  const int16_t* Run(size_t k, int32_t r) const { return Row(k, r) + radius_; }
  int16_t* Row(size_t level, int32_t r) const {
    return rows_[level].get() + static_cast<size_t>(r % (2 * radius_ + 1)) * width_;
  }

  const StepRaster& raster_;
  const int32_t radius_, width_;
  std::vector<std::unique_ptr<int16_t[]>> rows_;
  int32_t next_ = 0;  // the first row that is not there yet
};

// The lowest over each disk, of the squares that are asked for.
StepRaster ErodedByDisk(const StepRaster& raster, int32_t radius, const SquareBlocks& asked) {
  RunMinima minima(raster, radius);
  const std::vector<int32_t> half_widths = HalfWidths(radius);
  StepRaster lowest{raster.cols, raster.rows, std::vector<int16_t>(raster.heights.size(), kNoSurface)};
  asked.ForRuns([&](int32_t r, int32_t first, int32_t end) {
    minima.MoveTo(r);
    int16_t* values = lowest.heights.data() + static_cast<size_t>(r) * raster.cols + first;
    for (int32_t dy = 0; dy <= radius; ++dy) {
      const bool has_above = r + dy < raster.rows, has_below = r - dy >= 0;
      if (!has_above && !has_below) continue;
      const int32_t above = has_above ? r + dy : r - dy, below = has_below ? r - dy : r + dy;
      minima.Lower(above, below, half_widths[dy], {first, end}, values);
    }
  });
  return lowest;
}

// What is no surface stays so.
void Negate(StepRaster& raster) {
  for (int16_t& h : raster.heights) h = h == kNoSurface ? kNoSurface : static_cast<int16_t>(-h);
}

}  // namespace

StepRaster OpenedByDisk(const StepRaster& raster, int32_t radius, const SquareBlocks& asked) {
  StepRaster opened = ErodedByDisk(raster, radius, asked.GrownBy(radius));
  Negate(opened);
  opened = ErodedByDisk(opened, radius, asked);
  Negate(opened);
  return opened;
}

StepRaster OpenedByDisk(const StepRaster& raster, int32_t radius) {
  return OpenedByDisk(raster, radius, SquareBlocks::All(raster.cols, raster.rows));
}

}  // namespace tilemend
