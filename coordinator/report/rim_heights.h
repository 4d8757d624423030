// How high the boundary of a hole lies.
#ifndef TILEMEND_COORDINATOR_REPORT_RIM_HEIGHTS_H_
#define TILEMEND_COORDINATOR_REPORT_RIM_HEIGHTS_H_

#include <nlohmann/json.hpp>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Metres: the mean of the original vertices on the boundary; without any, of all vertices. Precondition: it has
// segments. Linear.
double RimHeight(const Plan& plan, const PlannedHole& hole);

// Metres, [lowest, highest]: of the original vertices on the boundary, and on those of the regions that tiles fill for
// themselves. null if there is none. Linear.
nlohmann::ordered_json RimHeightsJson(const Plan& plan, const PlannedHole& hole);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_RIM_HEIGHTS_H_
