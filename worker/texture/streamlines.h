// Lanes, kerbs and other structure of the ground, carried through a hole.
#ifndef TILEMEND_WORKER_TEXTURE_STREAMLINES_H_
#define TILEMEND_WORKER_TEXTURE_STREAMLINES_H_

#include <vector>

#include "worker/texture/ortho_raster.h"
#include "worker/texture/pixel_masks.h"
#include "worker/texture/square_lattice.h"

namespace tilemend {

// The direction of the ground's structure: the structure tensor (Forstner and Gulch 1987) of the brightness of
// sources. Gradients are saturated; the tensor is smoothed over 15 m, and extended where there is none. Squares of 1 m.
struct StructureField {
  SquareLattice squares;  // values: cosine and sine of the direction, coherence 0 to 1
};
StructureField StructureOf(const OrthoRaster& raster, const PixelMask& sources);

// Carries colours of sources along the structure into `colours` (one a pixel, the base) where `make` is set. It goes
// both ways to the next source, and takes the median of the first 12 m of sources there. The mean of both, weighted by
// 1 / distance, is blended in. It counts fully from coherence 0.4 on, and not at all below 0.25. Cost: O(pixels of
// `make` * length of their streamlines, at most 150 steps).
void CarryStructure(const OrthoRaster& raster, const PixelMask& sources, const StructureField& field,
                    const PixelMask& make, std::vector<Channels>& colours);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_STREAMLINES_H_
