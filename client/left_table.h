// What stays open: as a table, from report.json or from the plan in its form, and in lines.
#ifndef TILEMEND_CLIENT_LEFT_TABLE_H_
#define TILEMEND_CLIENT_LEFT_TABLE_H_

#include <nlohmann/json.hpp>
#include <string>

#include "coordinator/report/scene_report.h"

namespace tilemend {

// An empty line, the number of rows of `left` with `title` behind it ("left"), and the rows: holes first, with their
// id, cell, centre and area, at most kMostListedRows; then what is open but no hole, counted by what it is. Empty
// without rows.
std::string LeftText(const nlohmann::ordered_json& report, const std::string& title);

// Of a mesh alone, a line each: what stays open of holes, with where it is and why, and how many stay open as chosen
// (--largest-hole).
std::string LeftLines(const SceneReportInput& report);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_LEFT_TABLE_H_
