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

struct BaseOfSources {
  SquareLattice base;
  PixelMask plain;  // the sources that it was made from
};

// These, smoothed by 0.8 m and spread over the whole raster. Sources that are darker than 0.6 of it (shadows, dark
// cars) are taken out of `sources`. It is made again without them and without pixels that are brighter than 1.5 of
// their surroundings of some 8 m (marks, roofs, cars). Cost: linear in the pixels.
BaseOfSources BaseColours(const OrthoRaster& raster, PixelMask& sources);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_BASE_COLOURS_H_
