// What the report and the command line warn of in a plan.
#ifndef TILEMEND_COORDINATOR_REPORT_PLAN_WARNINGS_H_
#define TILEMEND_COORDINATOR_REPORT_PLAN_WARNINGS_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// What the user should know of the plan, one line each.
std::vector<std::string> PlanWarnings(const Plan& plan);

// kInvalidArgument if a reviewer's decisions were given and none of them is taken, as those of another scene (a
// decision that changes nothing is no error), or if surface is taken out at the rim of an area that is not known: it
// would stay open there.
absl::Status CheckAreas(const Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_PLAN_WARNINGS_H_
