// report.json: every hole, what became of it, and how long it took.
#ifndef TILEMEND_COORDINATOR_REPORT_SCENE_REPORT_H_
#define TILEMEND_COORDINATOR_REPORT_SCENE_REPORT_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/mesh/quality_tally.h"
#include "coordinator/plan/plan.h"

namespace tilemend {

struct SceneReportInput {
  const Plan* plan = nullptr;
  int64_t cells = 0;
  std::map<int32_t, std::string> failures;               // of holes that the workers could not fill
  std::map<int32_t, std::pair<int64_t, int64_t>> sizes;  // hole -> new vertices, triangles
  QualityTally quality;                                  // of all filled triangles
  std::vector<std::pair<std::string, double>> seconds;   // by stage, in order
  std::string surface;
  std::map<int32_t, HoldOut> of_clusters, of_holes;  // where tensions were chosen
  std::optional<double> given_tension;               // by the user, 1 / metre^2
  std::vector<std::string> warnings;
};

// What the report says is left open: of the plan, then of the workers.
std::vector<LeftOpen> LeftOf(const SceneReportInput& input);

// What the user should know of the plan, one line each.
std::vector<std::string> PlanWarnings(const Plan& plan);

// Names as the report and the command line print them.
const char* BorderName(BorderKind kind);
const char* KindName(HoleKind kind);
// "A" to "D", or null.
const char* TypeName(HoleType type);

// The JSON text (docs/user-guide.md, "The report"). Counts and rows are in the order of the plan.
std::string SceneReport(const SceneReportInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_SCENE_REPORT_H_
