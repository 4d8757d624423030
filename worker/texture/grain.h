// The fine grain of surface, apart from its colour.
#ifndef TILEMEND_WORKER_TEXTURE_GRAIN_H_
#define TILEMEND_WORKER_TEXTURE_GRAIN_H_

#include <cstdint>
#include <vector>

#include "worker/texture/ortho_raster.h"
#include "worker/texture/pixel_masks.h"
#include "worker/texture/square_lattice.h"

namespace tilemend {

// A number that looks random, of a place and a purpose: the same on every machine.
uint32_t HashOfPlace(int64_t x, int64_t y, uint32_t purpose);

// White noise of mean 0 at a pixel of the lattice, smoothed by 0.8 pixels: its standard deviation is `sigma`.
float WhiteGrain(int64_t column, int64_t row, double sigma);

// Adds grain to `colours` (one a pixel) where `make` is set: discrete spot noise (Galerne, Gousseau and Morel 2011). It
// is the sum of four windows of grain, each put at every pixel with a random sign. So it has the deviation and the
// spectrum of the windows, and never repeats. Grain is what sources differ from their colour smoothed over 1 m. A hash
// chooses the windows, of 2 m or 16 pixels, among those that hold sources alone and no marks. If there is none, the
// grain is white, with the sources' deviation. Sources of a plain colour do not count; if all are such, there is no
// grain. Cost: O(pixels of `make` * 1024) + O(pixels).
void AddGrain(const OrthoRaster& raster, const PixelMask& sources, const PixelMask& make,
              std::vector<Channels>& colours);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_GRAIN_H_
