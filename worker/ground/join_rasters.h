// Rasters of neighbouring tiles as one.
#ifndef TILEMEND_WORKER_GROUND_JOIN_RASTERS_H_
#define TILEMEND_WORKER_GROUND_JOIN_RASTERS_H_

#include <span>

#include "common/records/ground_raster.h"

namespace tilemend {

// Lowers `joined` to the surface of `other`, where both have squares. Precondition: squares of one size.
void LowerTo(const GroundRaster& other, GroundRaster& joined);

// The lowest surface of all, over the extent of all; empty if they are. Same precondition.
GroundRaster JoinRasters(std::span<const GroundRaster> rasters);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_GROUND_JOIN_RASTERS_H_
