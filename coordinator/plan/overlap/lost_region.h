// Whether a tile's own region of a hole is one.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_LOST_REGION_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_LOST_REGION_H_

#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// A tile's own region reaches beyond its hole, up to the tile's outline. One that winds around less than nine tenths of
// the hole's area, and 2 m2 less, has lost its way along chains of pieces. Less than that is boundary that runs to and
// fro. A region is also lost, whatever its size, if surface bounds the hole but none of it the region, and the region
// does not reach the tile's outline (`on_outline`). A patch there would hang on nothing.
//
// Seen from above; both in vertices of the plan. O(segments).
bool IsLostRegion(const Plan& plan, const std::vector<RimSegment>& hole, const std::vector<RimSegment>& region,
                  bool on_outline);

// Whether a hole is narrower than `width` metres in the mean, in space: pieces that part by less look so. Such a hole
// may have no own region at all. As above.
bool IsSliver(const Plan& plan, const std::vector<RimSegment>& hole, double width);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_LOST_REGION_H_
