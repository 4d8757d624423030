// Which pixels of a raster may be sources of colours.
#ifndef TILEMEND_WORKER_TEXTURE_PIXEL_MASKS_H_
#define TILEMEND_WORKER_TEXTURE_PIXEL_MASKS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "worker/texture/ortho_raster.h"
#include "worker/texture/square_lattice.h"
#include "worker/texture/synthesize.h"

namespace tilemend {

using PixelMask = std::vector<uint8_t>;  // by rows, as the raster's pixels; 0 or 1

// The pixels within `radius` pixels, along both axes, of one that is set. Cost: linear in the pixels.
PixelMask Dilated(const PixelMask& mask, const RasterFrame& frame, int32_t radius);

// At least one.
int32_t PixelsIn(double metres, const RasterFrame& frame);

// Takes out regions of pixels, connected by their sides, of fewer than `least` pixels. Cost: linear.
void DropSmallRegions(const RasterFrame& frame, int64_t least, PixelMask& mask);

// Known pixels of ground, in regions of 4 m2 or more. They are at most 0.4 m above a morphological opening of 20 m.
// They are 0.5 m away from the fill, from pixels of objects and from pixels that are not known. Cost: linear in the
// pixels, but for the opening (squares of 0.5 m times 80).
PixelMask GroundPixels(const OrthoRaster& raster, std::span<const FillPixel> fill);

// The surface that a fill goes on from: known pixels up to 3 m beside it that are within 0.4 m of its height, whatever
// they are. They are 0.25 m away from the fill, where texels are blurred, and 0.5 m from what stands higher. `level`:
// how high the fill is, or would be. Cost: linear in the pixels.
PixelMask SurfaceBeside(const OrthoRaster& raster, std::span<const FillPixel> fill, const SquareLattice& level);

// Known pixels within 0.6 m of the level, one pixel away from the fill.
PixelMask WaterPixels(const OrthoRaster& raster, std::span<const FillPixel> fill, double level);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_PIXEL_MASKS_H_
