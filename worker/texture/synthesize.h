// Colours for filled surface, made from the ground or the water around it.
#ifndef TILEMEND_WORKER_TEXTURE_SYNTHESIZE_H_
#define TILEMEND_WORKER_TEXTURE_SYNTHESIZE_H_

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/util/colour.h"
#include "worker/texture/ortho_raster.h"

namespace tilemend {

// What a pixel of a fill is to look like.
enum class FillPixel : uint8_t {
  kNone,     // no fill
  kGround,   // made from ground
  kWater,    // made from water
  kForeign,  // a hole of another cell: no source, and no colour is needed
};

struct FillMap {
  std::vector<FillPixel> pixels;  // as the raster's
  std::vector<float> heights;     // of the fill, metres; read where it is ground or water
};

struct FillLook {
  double water_level = 0;               // metres
  Rgb ground = {};                      // where no pixel of the raster is ground
  Rgb water = {};                       // of all water, but beside its rim
  std::optional<Rgb> given_water = {};  // all water gets this colour
};

// A larger raster must have a coarser texel.
inline constexpr int64_t kMostRasterPixels = int64_t{4} << 20;
// What Synthesize holds beside the raster, and the raster.
inline constexpr int64_t kBytesPerPixel = 64;

// The raster's colours, those of kGround and kWater made anew. Pixels without surface or fill have that of the nearest
// one in their row, or else column.
//  - Base: the geometric median of the surface up to 40 m away and at most 3 m beside the hole that is within 0.4 m of
//    the fill's height, by medians of squares of 0.5 m (base_colours.h). Of water the flat colour, that of its shore,
//    so that a body looks the same in all cells.
//  - Lanes and kerbs: along the direction of the structure around, where there is one (streamlines.h). Sources are
//    pixels at most 0.4 m above an opening of 20 m and within 1 m of the fill's height, 0.5 m away from the fill and
//    from objects, and no shadows.
//  - Rim: the step of colours at the rim is spread inward, and fades over some 2 m. Of water that is the step to
//  surface
//    within 0.6 m of the level.
//  - Grain: noise with the spectrum of the sources (grain.h); of water white noise.
// All lattices are anchored to absolute coordinates: equal rasters of two cells give equal colours, and results depend
// on nothing else. Cost: linear in the pixels of the raster; of the fill, in the length of its streamlines.
std::vector<Rgb> Synthesize(const OrthoRaster& raster, const FillMap& fill, const FillLook& look);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_SYNTHESIZE_H_
