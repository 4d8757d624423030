#include "coordinator/report/cleared_report.h"

#include <cmath>
#include <cstdint>
#include <map>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/mesh/clear_area.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostNamed = 10;  // polygons in warnings
constexpr double kPlaces = 1e4;    // heights are reported to a tenth of a millimetre

Json TileRows(const std::map<CellId, int64_t>& triangles_of) {
  Json rows = Json::array();
  for (const auto& [cell, triangles] : triangles_of) {
    rows.push_back({{"cell", {cell.col, cell.row}}, {"triangles", triangles}});
  }
  return rows;
}

int64_t SumOf(const std::map<CellId, int64_t>& triangles_of) {
  int64_t sum = 0;
  for (const auto& [cell, triangles] : triangles_of) sum += triangles;
  return sum;
}

// The rules are those of AreasThatClear and TallyHeights.
std::string WhyNothing(const ClearedArea& area) {
  if (area.water && !area.top) return "it has no level, because no triangle has its middle in it; give it a level";
  const std::string below = area.top ? absl::StrFormat(" below %.2f m", *area.top) : "";
  return absl::StrFormat("no triangle%s lies in it by more than %g %% of its area", below, 100 * kClearedShare);
}

}  // namespace

Json ClearedJson(const std::vector<ClearedArea>& cleared, const std::set<CellId>& chosen) {
  std::map<CellId, int64_t> all;
  Json areas = Json::array();
  for (const ClearedArea& area : cleared) {
    std::map<CellId, int64_t> written;
    for (const auto& [cell, triangles] : area.triangles_of) {
      if (!chosen.empty() && !chosen.contains(cell)) continue;
      written[cell] = triangles;
      all[cell] += triangles;
    }
    Json row = {{"feature", area.label}, {"water", area.water}};
    if (area.top) row["top_m"] = std::round(*area.top * kPlaces) / kPlaces;
    row["triangles"] = SumOf(written);
    row["tiles"] = TileRows(written);
    areas.push_back(std::move(row));
  }
  return {{"triangles", SumOf(all)}, {"tiles", TileRows(all)}, {"areas", std::move(areas)}};
}

std::vector<std::string> ClearedWarnings(const std::vector<ClearedArea>& cleared) {
  std::vector<std::string> warnings;
  for (const ClearedArea& area : cleared) {
    if (!area.triangles_of.empty()) continue;
    warnings.push_back(absl::StrCat("polygon ", area.label, ": nothing was taken out: ", WhyNothing(area)));
  }
  KeepFirst(kMostNamed, "polygons of which nothing was taken out (cleared in the report)", warnings);
  return warnings;
}

}  // namespace tilemend
