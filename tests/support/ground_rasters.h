// Ground rasters by a function.
#ifndef TILEMEND_TESTS_SUPPORT_GROUND_RASTERS_H_
#define TILEMEND_TESTS_SUPPORT_GROUND_RASTERS_H_

#include <cstdint>
#include <functional>

#include "common/records/ground_raster.h"

namespace tilemend {

// With squares of 1 m.
inline GroundRaster BuiltRaster(int32_t col, int32_t row, int32_t cols, int32_t rows,
                                const std::function<double(int32_t, int32_t)>& height) {
  GroundRaster raster = EmptyRaster(1, col, row, cols, rows);
  for (int32_t r = row; r < row + rows; ++r) {
    for (int32_t c = col; c < col + cols; ++c) raster.heights[raster.IndexOf(c, r)] = static_cast<float>(height(c, r));
  }
  return raster;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_GROUND_RASTERS_H_
