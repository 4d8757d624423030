#include "client/water_table.h"

#include <algorithm>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/json_access.h"
#include "client/output.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

double AreaOf(const Json& body) { return Number(Member(body, "area_m2")); }

std::vector<std::string> Row(const Json& body) {
  const Json& level = Member(body, "level_m");
  return {level.is_array() ? "river" : "lake", LevelText(level),
          AreaText(Member(body, "area_m2")),   Text(Member(body, "cells")),
          LevelText(Member(body, "spread_m")), LevelText(Member(body, "rim_m")),
          Text(Member(body, "rim_vertices")),  Text(Member(body, "decided_by"))};
}

}  // namespace

std::string WaterText(const Json& report, const std::string& title) {
  std::vector<Json> bodies;
  for (const Json& body : Member(report, "water")) {
    if (body.is_object()) bodies.push_back(body);
  }
  if (bodies.empty()) return "";
  std::stable_sort(bodies.begin(), bodies.end(), [](const Json& a, const Json& b) { return AreaOf(a) > AreaOf(b); });
  std::vector<std::vector<std::string>> rows;
  for (size_t i = 0; i < std::min(bodies.size(), kMostListedRows); ++i) rows.push_back(Row(bodies[i]));
  return absl::StrCat(
      "\n", bodies.size(), " ", title, "\n",
      Table({"water", "level, m", "area, m2", "cells", "spread, m", "rim, m", "rim vertices", "decided by"}, rows),
      MoreText(bodies.size(), "see `water` in the report"));
}

}  // namespace tilemend
