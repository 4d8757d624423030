// What the report tells of water.
#ifndef TILEMEND_COORDINATOR_REPORT_WATER_ROWS_H_
#define TILEMEND_COORDINATOR_REPORT_WATER_ROWS_H_

#include <nlohmann/json.hpp>

#include "coordinator/report/scene_report.h"

namespace tilemend {

// The level of a lake; of a river those of its upper and its lower end.
nlohmann::ordered_json LevelJson(const WaterBody& body);

// A row for each body of water of which a hole was filled (docs/user-guide.md, "A row of `water`").
nlohmann::ordered_json WaterRows(const SceneReportInput& input);

// What became of the areas of --water and --clear.
nlohmann::ordered_json WaterAreaRows(const Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_WATER_ROWS_H_
