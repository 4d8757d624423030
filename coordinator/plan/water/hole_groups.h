// What a body of water can be: a cluster of open holes, or a closed hole.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_HOLE_GROUPS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_HOLE_GROUPS_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/area_cover.h"

namespace tilemend {

// The clusters of open holes, and the closed holes that face up and project; each in order of their first hole. Holes
// that can't be filled are in none. Cost O(n log n) in the plan's holes and segments.
std::vector<std::vector<int32_t>> GroupHoles(const Plan& plan);

// Rims and seams of the holes, seen from above; seams between two of them occur twice.
std::vector<PlaneSegment> BoundaryOf(const Plan& plan, const std::vector<int32_t>& holes);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_HOLE_GROUPS_H_
