// report.json: every hole, what became of it, and how long it took.
#ifndef TILEMEND_COORDINATOR_REPORT_SCENE_REPORT_H_
#define TILEMEND_COORDINATOR_REPORT_SCENE_REPORT_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/options/option.h"
#include "common/records/level_counts.h"
#include "common/records/weld.h"
#include "coordinator/plan/types/plan_types.h"
#include "coordinator/waves/scene_outcome.h"

namespace tilemend {

struct SceneReportInput {
  const Plan* plan = nullptr;
  std::string scene;  // path
  std::string date;   // when the result was made (common/util/utc.h)
  std::vector<ReportedOption> options;
  std::map<std::string, std::string> files;  // digests of the files that options name, by these
  int64_t cells = 0;
  SceneOutcome outcome;
  std::vector<std::pair<std::string, double>> seconds;  // by step, in order
  std::vector<std::string> warnings;
  std::vector<LevelCounts> levels;    // of tiles with several levels of detail, the coarsest first
  std::optional<WeldRecord> weld;     // of a single mesh, if it was asked for
  int64_t tasks = 0, taken_over = 0;  // how many there were, and were taken over from an earlier job
  int64_t tiles = 0, tiles_kept = 0;  // likewise of tiles: those that lay there as they are to be
  std::string key;                    // of scene and options (coordinator/jobs/earlier_output.h); "": none
};

// All that the report has: the input's own, those of the plan, and of patches that fold back.
std::vector<std::string> WarningsOf(const SceneReportInput& input);

// Names as the report and the command line print them.
const char* BorderName(BorderKind kind);
const char* KindName(HoleKind kind);
// How a hole was filled: "water" or "level ground" of what is filled flat, else the way.
const char* MethodOf(const Plan& plan, const PlannedHole& hole, FillWay way);
// "A" to "D", or null.
const char* TypeName(HoleType type);

// The JSON text (docs/user-guide.md, "Report"). Counts and rows are in the order of the plan.
std::string SceneReport(const SceneReportInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_SCENE_REPORT_H_
