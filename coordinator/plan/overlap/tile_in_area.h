// A tile's own boundary where an area's polygon ends inside it.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_TILE_IN_AREA_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_TILE_IN_AREA_H_

#include <cstdint>
#include <vector>

#include "common/records/survey_record.h"
#include "coordinator/plan/overlap/area_outside.h"

namespace tilemend {

struct TileInArea {
  SurveyRecord record;
  std::vector<int32_t> edge_of;  // of each edge of the tile's record: in `record`; -1: it is outside
};

// The boundary of a tile with what is outside the area as surface, up to the box of `outside`, which is the tile's
// outline. Its vertices are those of the tile and AreaOutside::points. Edges of the tile that the area's edge crosses
// stay whole. The way along the area begins at their ends outside, so that all of the area is covered. Edges along the
// area have piece kAreaPiece (rim.h). Bands are left out.
//   cut  of each edge: whether it may be crossed (ClippedTile::cut)
// Cost as FindWoundRegion.
TileInArea TakeInArea(const SurveyRecord& record, const std::vector<bool>& cut, const AreaOutside& outside);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_TILE_IN_AREA_H_
