// The holes that a reviewer decided on, and which area of the user's says what the others are.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_DECIDED_HOLES_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_DECIDED_HOLES_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/area_index.h"

namespace tilemend {

// Sets Plan::decisions, by WaterAreas with a decision. The last one that covers more than half of a cluster of open
// holes, or of a closed hole, decides on it; where none does, those that say the same may together (FindDecidingArea).
// An area of which more than half lies in one of them is about that one alone: not about holes above or below it. Of
// several such it is about the one that it fits best: a hole in a roof, not the street below.
// Holes whose decision is kOpen get the failure kLeftByDecision, unless they have one. To be called when clusters are
// known and before water is found. Once cancelled it ends soon. Cost as AreaIndex for each group, twice.
void DecideHoles(const std::vector<WaterArea>& areas, Plan& plan, const std::function<bool()>& is_cancelled = {});

// The area that decides whether the holes of a group are water, or none. A reviewer's decision comes first; it may be
// to accept, which decides nothing. Holes in pieces that hang over others are in no other area: what it is about lies
// below them. An area that is cleared has no part in holes whose rim is all above what it takes out.
//
//   index  of `areas`
//
// Precondition: DecideHoles was called. Cost as AreaIndex.
std::optional<size_t> DeciderOf(const Plan& plan, const std::vector<int32_t>& holes,
                                const std::vector<WaterArea>& areas, const AreaIndex& index);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_DECIDED_HOLES_H_
