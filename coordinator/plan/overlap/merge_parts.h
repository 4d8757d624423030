// From the plan of a scene in parts to that of its tiles.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_MERGE_PARTS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_MERGE_PARTS_H_

#include "coordinator/plan/overlap/tile_parts.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Makes one hole of the holes of a tile that touch along lines between its parts, and names tiles where the plan named
// parts. The seams between parts stay in the hole's segments, once each way, and each part keeps its own region. Must
// come before clusters and layers. Nothing to do where tiles are whole. Cost O(n log n) in the segments.
void MergeParts(const PlanInput& input, const TileParts& parts, Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_MERGE_PARTS_H_
