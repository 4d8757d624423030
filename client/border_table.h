// How the tiles of a scene meet, for people.
#ifndef TILEMEND_CLIENT_BORDER_TABLE_H_
#define TILEMEND_CLIENT_BORDER_TABLE_H_

#include <nlohmann/json.hpp>
#include <string>

namespace tilemend {

// The field `borders` of a report: how many pairs of tiles meet in which way, and how far their fills are apart at
// most. Then the pairs whose original surfaces are more than 0.1 m apart, or their fills more than 0.02 m, the furthest
// first. Begins with an empty line; "" if there is nothing to tell.
std::string BordersText(const nlohmann::ordered_json& report);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_BORDER_TABLE_H_
