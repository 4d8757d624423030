// Which open holes share a grid boundary.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_TOUCHING_HOLES_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_TOUCHING_HOLES_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Pairs of holes, ascending, each once: those on the two sides of one seam segment. Holes that failed take no part.
// Where one of them is water, both are of the same body.
std::vector<std::pair<int32_t, int32_t>> HolesThatTouch(const Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_TOUCHING_HOLES_H_
