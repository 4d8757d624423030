// Level, low, large regions of a surface: where water may be there as surface.
#ifndef TILEMEND_WORKER_PROPOSE_LEVEL_REGIONS_H_
#define TILEMEND_WORKER_PROPOSE_LEVEL_REGIONS_H_

#include <vector>

#include "common/mesh/plane_polygon.h"
#include "common/records/ground_raster.h"

namespace tilemend {

// Chosen on two levels of detail of a photogrammetric city (a canal, a pond), a wooded river bank of lidar and seven
// sites without water (docs/decisions/2026-11-26-clear-polygons.md).
struct LevelRegionOptions {
  double bank = 0.5;          // metres: how far the shore rises at least, and the heights of water scatter at most
  double growth = 1.35;       // how much larger the region may be at `bank` above its own level
  double depth_share = 0.45;  // how much of it may lie more than `bank` below its own level: noise of water
  double shore_share = 0.65;  // along how much of its rim ground must be higher than the water by `bank`
  double shore_reach = 10;    // metres: how far behind the rim that ground may be: trees and walls stand before it
  double min_area = 100;      // m2
  int32_t smoothing = 2;      // squares: medians of so many to each side
};

struct LowRegion {
  PlanePolygon outline;    // metres; islands from `min_area` on are left out
  double level = 0;        // metres: where its heights are densest (half-sample mode)
  double sigma = 0;        // metres: 1.4826 x the median distance of its heights from the level
  double area = 0;         // m2
  double shore_share = 0;  // of its rim, behind which ground is higher by `bank`
};

// A region below a level may be water if most of its squares lie within `bank` of its level, and higher ground lies
// around it. It must also hardly grow when the level rises by `bank` (Matas et al. 2002: a maximally stable extremal
// region of heights). Of regions inside each other the one that does so most clearly is taken. What lies at the edge of
// the raster counts as if the raster ended in a wall. In order of area, the largest first.
//
//   heights    the lowest surface in each square
//   is_ground  for each of them, whether it has surface that is no object
// Precondition: as many of both. Cost O(n log n) for n squares.
std::vector<LowRegion> FindLevelRegions(const GroundRaster& heights, const std::vector<bool>& is_ground,
                                        const LevelRegionOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PROPOSE_LEVEL_REGIONS_H_
