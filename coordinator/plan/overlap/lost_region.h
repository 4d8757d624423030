// Whether a tile's own region of a hole is one.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_LOST_REGION_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_LOST_REGION_H_

#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// A tile's own region is its hole, and what lies beyond the grid lines up to the tile's outline: `beyond` m2 at most.
// One that winds around a tenth of the hole's area less, or more than both, and 2 m2, has lost its way along chains of
// pieces. Less than that is boundary that runs to and fro. Seen from above; both in vertices of the plan. O(segments).
bool IsLostRegion(const Plan& plan, const std::vector<RimSegment>& hole, const std::vector<RimSegment>& region,
                  double beyond);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_LOST_REGION_H_
