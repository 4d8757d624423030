// Whether a tile's own region of a hole is one.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_LOST_REGION_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_LOST_REGION_H_

#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// A tile's own region reaches beyond its hole, up to the tile's outline. One that winds around less than nine tenths of
// the hole's area, and 2 m2 less, has lost its way along chains of pieces. Less than that is boundary that runs to and
// fro. Seen from above; both in vertices of the plan. O(segments).
bool IsLostRegion(const Plan& plan, const std::vector<RimSegment>& hole, const std::vector<RimSegment>& region);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_LOST_REGION_H_
