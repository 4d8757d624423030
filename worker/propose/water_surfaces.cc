#include "worker/propose/water_surfaces.h"

#include "worker/ground/join_rasters.h"

namespace tilemend {

std::vector<LowRegion> FindWaterSurfaces(std::span<const GroundRaster> rasters, const GroundFilterOptions& ground,
                                         const LevelRegionOptions& options) {
  const GroundRaster lowest = JoinRasters(rasters);
  if (lowest.empty()) return {};
  const FilteredGround filtered(lowest, ground);
  std::vector<bool> is_ground;
  for (int32_t row = lowest.row; row < lowest.row + lowest.rows; ++row) {
    for (int32_t col = lowest.col; col < lowest.col + lowest.cols; ++col) {
      is_ground.push_back(filtered.IsGround(col, row));
    }
  }
  return FindLevelRegions(lowest, is_ground, options);
}

}  // namespace tilemend
