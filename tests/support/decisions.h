// A reviewer's decisions on the holes of an output.
#ifndef TILEMEND_TESTS_SUPPORT_DECISIONS_H_
#define TILEMEND_TESTS_SUPPORT_DECISIONS_H_

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "common/util/files.h"

namespace tilemend {

// holes.geojson of `out` with `decision`, and `level` above the scene's origin, on all holes that were filled as water;
// or on all holes.
inline std::string DecisionsOnHoles(const std::string& out, const std::string& decision,
                                    std::optional<double> level = std::nullopt, bool water_only = true) {
  nlohmann::json holes = nlohmann::json::parse(ReadFile(out + "/holes.geojson").value());
  for (nlohmann::json& feature : holes["features"]) {
    nlohmann::json& properties = feature["properties"];
    if (water_only && properties["water"] != true) continue;
    properties["decision"] = decision;
    properties["level_m"] = level ? nlohmann::json(*level) : nlohmann::json();
  }
  return holes.dump();
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_DECISIONS_H_
