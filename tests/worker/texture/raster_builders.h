// Rasters of made ground.
#ifndef TILEMEND_TESTS_WORKER_TEXTURE_RASTER_BUILDERS_H_
#define TILEMEND_TESTS_WORKER_TEXTURE_RASTER_BUILDERS_H_

#include <cstdint>
#include <functional>
#include <vector>

#include "worker/texture/ortho_raster.h"
#include "worker/texture/synthesize.h"

namespace tilemend {

// Flat ground at height 0 with a colour at each pixel of the lattice.
inline OrthoRaster RasterOf(const RasterFrame& frame, const std::function<Rgb(int64_t column, int64_t row)>& colour) {
  OrthoRaster raster(frame);
  for (int32_t y = 0; y < frame.height; ++y) {
    for (int32_t x = 0; x < frame.width; ++x) {
      const size_t at = frame.At(x, y);
      raster.colours[at] = colour(frame.column + x, frame.row + y);
      raster.heights[at] = 0;
      raster.known[at] = 1;
    }
  }
  return raster;
}

// Fill in the pixels from (x0, y0) to before (x1, y1), where the raster's surface goes.
inline std::vector<FillPixel> CutHole(OrthoRaster& raster, int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                                      FillPixel kind) {
  std::vector<FillPixel> fill(raster.frame.size(), FillPixel::kNone);
  for (int32_t y = y0; y < y1; ++y) {
    for (int32_t x = x0; x < x1; ++x) {
      const size_t at = raster.frame.At(x, y);
      fill[at] = kind;
      raster.heights[at] = kNoSurface;
      raster.known[at] = 0;
      raster.colours[at] = {255, 0, 255};
    }
  }
  return fill;
}

// That fill at height 0.
inline FillMap MapOf(const std::vector<FillPixel>& pixels) { return {pixels, std::vector<float>(pixels.size())}; }

}  // namespace tilemend

#endif  // TILEMEND_TESTS_WORKER_TEXTURE_RASTER_BUILDERS_H_
