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

// For squares of 8 m, the geometric median of the known ones of `squares` within 40 m of their middles. Weights fall
// from 1 to 0 with the distance (biweight). The median of all counts as much as one square at the
// place itself. So where some are near, two rasters that hold the same surface within 46 m of a place give it the same
// colour, to a tenth of a grey level. Squares that are not needed to interpolate at pixels of `wanted` may stay 0.
// Precondition: one is known. Cost: known squares within 40 m, times squares of 8 m.
SquareLattice MiddlesNear(const RasterFrame& frame, const SquareLattice& squares, const PixelMask& wanted);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_BASE_COLOURS_H_
