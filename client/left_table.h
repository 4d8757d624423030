// What stays open: as a table, from report.json or from the plan in its form, and in lines.
#ifndef TILEMEND_CLIENT_LEFT_TABLE_H_
#define TILEMEND_CLIENT_LEFT_TABLE_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "coordinator/report/scene_report.h"

namespace tilemend {

// An empty line, the number of rows of `left` with `title` behind it ("left"), and the rows. Holes come first, with
// their id, cell, centre and area, at most kMostListedRows. Then comes what is open but no hole, counted by what it is.
// Empty without rows. `columns`: those of a terminal, which the tables keep to (TableWithTexts); 0: none.
std::string LeftText(const nlohmann::ordered_json& report, const std::string& title, size_t columns = 0);

// For a mesh without a scene, a line each: the holes that stay open, with where each is and why. The last line counts
// those that stay open as chosen (--largest-hole).
std::string LeftLines(const SceneReportInput& report);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_LEFT_TABLE_H_
