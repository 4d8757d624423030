// The rims of holes as chains of edges of the original surface.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_RIM_CHAINS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_RIM_CHAINS_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/level_evidence.h"

namespace tilemend {

// The rim of some holes: edges between two original vertices, linked over borders of cells. Seams, outlines
// of pieces and the edge of an area are in none. A chain around a hole begins at the same edge in any partition. Cost
// O(n log n) in the holes' segments.
std::vector<RimChain> RimChainsOf(const Plan& plan, const std::vector<int32_t>& holes);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_RIM_CHAINS_H_
