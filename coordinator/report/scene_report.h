// report.json: every hole, what became of it, and how long it took.
#ifndef TILEMEND_COORDINATOR_REPORT_SCENE_REPORT_H_
#define TILEMEND_COORDINATOR_REPORT_SCENE_REPORT_H_

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/records/surface.h"
#include "coordinator/plan/types/plan_types.h"
#include "coordinator/waves/scene_outcome.h"

namespace tilemend {

struct SceneReportInput {
  const Plan* plan = nullptr;
  int64_t cells = 0;
  SceneOutcome outcome;
  std::vector<std::pair<std::string, double>> seconds;  // by step, in order
  Surface surface = kDefaultSurface;
  std::optional<double> given_tension;  // by the user, 1 / metre^2
  std::vector<std::string> warnings;
};

// What the report says is left open: of the plan, then of its outcome.
std::vector<LeftOpen> LeftOf(const SceneReportInput& input);

// What the user should know of the plan, one line each.
std::vector<std::string> PlanWarnings(const Plan& plan);

// Names as the report and the command line print them.
const char* BorderName(BorderKind kind);
const char* KindName(HoleKind kind);
const char* WayName(FillWay way);
// "A" to "D", or null.
const char* TypeName(HoleType type);

// The JSON text (docs/user-guide.md, "The report"). Counts and rows are in the order of the plan.
std::string SceneReport(const SceneReportInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_SCENE_REPORT_H_
