// report.json: every hole, what became of it, and how long it took.
#ifndef TILEMEND_COORDINATOR_SERVICE_SCENE_REPORT_H_
#define TILEMEND_COORDINATOR_SERVICE_SCENE_REPORT_H_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "coordinator/plan/plan.h"

namespace tilemend {

struct SceneReportInput {
  const Plan* plan = nullptr;
  int64_t cells = 0;
  std::map<int32_t, std::string> failures;               // of holes that the workers could not fill
  std::map<int32_t, std::pair<int64_t, int64_t>> sizes;  // hole -> new vertices, triangles
  std::vector<std::pair<std::string, double>> seconds;   // by stage, in order
  std::string surface;
  std::vector<std::string> warnings;
};

// What the report says is left open: of the plan, then of the workers.
std::vector<LeftOpen> LeftOf(const SceneReportInput& input);

// Names as the report and the command line print them.
const char* BorderName(BorderKind kind);
const char* KindName(HoleKind kind);
// "A" to "D", or null.
const char* TypeName(HoleType type);

// The JSON text (docs/user-guide.md, "The report"). Counts and rows are in the order of the plan.
std::string SceneReport(const SceneReportInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_SCENE_REPORT_H_
