// What stays open, as a table: from report.json, or from the plan in its form.
#ifndef TILEMEND_CLIENT_LEFT_TABLE_H_
#define TILEMEND_CLIENT_LEFT_TABLE_H_

#include <nlohmann/json.hpp>
#include <string>

namespace tilemend {

// An empty line, the number of rows of `left` with `title` behind it ("left"), and the rows: holes first, with their
// id, cell, centre and area, at most kMostListedRows; then what is open but no hole, counted by what it is. Empty
// without rows.
std::string LeftText(const nlohmann::ordered_json& report, const std::string& title);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_LEFT_TABLE_H_
