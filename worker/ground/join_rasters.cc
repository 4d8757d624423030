#include "worker/ground/join_rasters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tilemend {

void LowerTo(const GroundRaster& other, GroundRaster& joined) {
  const int32_t first = std::max(other.col, joined.col),
                end = std::min(other.col + other.cols, joined.col + joined.cols);
  for (int32_t r = std::max(other.row, joined.row); r < std::min(other.row + other.rows, joined.row + joined.rows);
       ++r) {
    for (int32_t c = first; c < end; ++c) {
      float& lowest = joined.heights[joined.IndexOf(c, r)];
      const float height = other.heights[other.IndexOf(c, r)];
      if (!std::isnan(height) && !(lowest <= height)) lowest = height;
    }
  }
}

GroundRaster JoinRasters(std::span<const GroundRaster> rasters) {
  int32_t col = INT32_MAX, row = INT32_MAX, end_col = INT32_MIN, end_row = INT32_MIN;
  double square = 1;
  for (const GroundRaster& r : rasters) {
    if (r.empty()) continue;
    square = r.square;
    col = std::min(col, r.col);
    row = std::min(row, r.row);
    end_col = std::max(end_col, r.col + r.cols);
    end_row = std::max(end_row, r.row + r.rows);
  }
  if (col >= end_col) return {};
  GroundRaster joined = EmptyRaster(square, col, row, end_col - col, end_row - row);
  for (const GroundRaster& r : rasters) LowerTo(r, joined);
  return joined;
}

}  // namespace tilemend
