// The holes of a plan as the coordinator's page shows them before they are filled.
#ifndef TILEMEND_COORDINATOR_REPORT_PLANNED_HOLES_H_
#define TILEMEND_COORDINATOR_REPORT_PLANNED_HOLES_H_

#include <cstddef>
#include <set>
#include <string>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// JSON text {"holeCount", "holes", "planned": true}: at most `most` rows in the form of PageHoles, those that stay open
// first, then the largest. "filled": whether it is to be filled. `chosen`: only holes of these cells; empty: all. Cost:
// O(n log n).
std::string PlannedHolesJson(const Plan& plan, const std::set<CellId>& chosen, size_t most);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_PLANNED_HOLES_H_
