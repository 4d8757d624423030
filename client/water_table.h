// The bodies of water of a report, for people.
#ifndef TILEMEND_CLIENT_WATER_TABLE_H_
#define TILEMEND_CLIENT_WATER_TABLE_H_

#include <nlohmann/json.hpp>
#include <string>

namespace tilemend {

// A table of the report's field `water` under `title`: the largest first, at most kMostListedRows, with an empty line
// before. "" if it is no list or empty.
std::string WaterText(const nlohmann::ordered_json& report, const std::string& title);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_WATER_TABLE_H_
