// Where the surface of a scene looks like water.
#ifndef TILEMEND_WORKER_PROPOSE_WATER_SURFACES_H_
#define TILEMEND_WORKER_PROPOSE_WATER_SURFACES_H_

#include <span>
#include <vector>

#include "common/records/ground_raster.h"
#include "worker/ground/ground_filter.h"
#include "worker/propose/level_regions.h"

namespace tilemend {

// The level, low, large regions of the ground of all rasters together (level_regions.h), the largest first.
// Precondition: squares of one size. Cost over the extent of all, without gaps of more than kGroundReach: some 3 s and
// 100 MB for 1 km2.
std::vector<LowRegion> FindWaterSurfaces(std::span<const GroundRaster> rasters, const GroundFilterOptions& ground = {},
                                         const LevelRegionOptions& options = {});

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PROPOSE_WATER_SURFACES_H_
