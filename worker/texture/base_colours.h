// The colours of ground or water without its details, also where there is none.
#ifndef TILEMEND_WORKER_TEXTURE_BASE_COLOURS_H_
#define TILEMEND_WORKER_TEXTURE_BASE_COLOURS_H_

#include "worker/texture/ortho_raster.h"
#include "worker/texture/pixel_masks.h"
#include "worker/texture/square_lattice.h"

namespace tilemend {

// Grey levels of a colour, 0 to 255.
float Brightness(const Channels& colour);
Channels ChannelsOf(Rgb colour);

// The medians of squares of 0.5 m in which at least a quarter of the pixels are sources. Cost: linear in the pixels.
SquareLattice MedianSquares(const OrthoRaster& raster, const PixelMask& sources);

// These, smoothed by 0.8 m and spread over the whole raster. Sources that are darker than 0.6 of it (shadows, dark
// cars) are taken out of `sources`, and it is made again without them. Cost: linear in the pixels.
SquareLattice BaseColours(const OrthoRaster& raster, PixelMask& sources);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_BASE_COLOURS_H_
