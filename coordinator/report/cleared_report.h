// What was taken out of the tiles, for report.json and as warnings.
#ifndef TILEMEND_COORDINATOR_REPORT_CLEARED_REPORT_H_
#define TILEMEND_COORDINATOR_REPORT_CLEARED_REPORT_H_

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "coordinator/waves/clearing.h"

namespace tilemend {

// The member `cleared` of the report: triangles in all, of each tile and of each area. Tiles that are not in `chosen`
// are not written, so nothing is taken out of them; an empty set chooses all.
nlohmann::ordered_json ClearedJson(const std::vector<ClearedArea>& cleared, const std::set<CellId>& chosen);

// One for each area that took nothing out, with the reason.
std::vector<std::string> ClearedWarnings(const std::vector<ClearedArea>& cleared);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_CLEARED_REPORT_H_
