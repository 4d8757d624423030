#include "coordinator/plan/water/area_index.h"

#include <utility>

namespace tilemend {

AreaIndex::AreaIndex(std::span<const WaterArea> areas, IsCancelled is_cancelled)
    : areas_(areas),
      is_cancelled_(std::move(is_cancelled)),
      tree_(areas.size(), [&](size_t a) -> const PlanePolygon& { return areas[a].polygon; }) {}

}  // namespace tilemend
