// The colours of ground or water without its details.
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

// Takes out sources that are darker than 0.6 of the medians around them, smoothed by 0.8 m: shadows, dark cars. Cost:
// linear in the pixels.
void DropShadows(const OrthoRaster& raster, PixelMask& sources);

// The geometric median of the known squares: the colour from which the sum of the ways to theirs is least (Weiszfeld
// 1937). Half of them may be anything. Precondition: one is known. Cost: linear.
Channels MiddleOf(const SquareLattice& squares);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_BASE_COLOURS_H_
