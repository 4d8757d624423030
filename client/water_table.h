// The bodies of water of a report, for people.
#ifndef TILEMEND_CLIENT_WATER_TABLE_H_
#define TILEMEND_CLIENT_WATER_TABLE_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace tilemend {

// A table of the report's field `water` under `title`: the largest first, at most kMostListedRows, with an empty line
// before. "" if it is no list or empty. `columns`: those of a terminal, where columns of the table are left out if
// there is no room (FittedTable); 0: none.
std::string WaterText(const nlohmann::ordered_json& report, const std::string& title, size_t columns = 0);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_WATER_TABLE_H_
