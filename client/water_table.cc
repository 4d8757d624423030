#include "client/water_table.h"

#include <algorithm>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/output.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostRows = 50;

double AreaOf(const Json& body) {
  const auto area = body.find("area_m2");
  return area != body.end() && area->is_number() ? area->get<double>() : 0;
}

// Metres with three decimals: a number, or "lowest to highest" of two.
std::string Millimetres(const Json& value) {
  if (value.is_array() && value.size() == 2) return absl::StrCat(Millimetres(value[0]), " to ", Millimetres(value[1]));
  return value.is_number() ? absl::StrFormat("%.3f", value.get<double>()) : value.dump();
}

}  // namespace

std::string WaterText(const Json& report, const std::string& title) {
  const auto water = report.find("water");
  if (water == report.end() || !water->is_array() || water->empty()) return "";
  std::vector<Json> bodies;
  std::copy_if(water->begin(), water->end(), std::back_inserter(bodies), [](const Json& b) { return b.is_object(); });
  std::stable_sort(bodies.begin(), bodies.end(), [](const Json& a, const Json& b) { return AreaOf(a) > AreaOf(b); });
  if (bodies.size() > kMostRows) bodies.resize(kMostRows);
  std::vector<std::vector<std::string>> rows;
  for (const Json& body : bodies) {
    std::vector<std::string> row;
    for (const char* field : {"level_m", "spread_m", "rim_m"}) row.push_back(Millimetres(body.value(field, Json())));
    for (const char* field : {"rim_vertices", "area_m2", "cells"}) row.push_back(body.value(field, Json()).dump());
    const Json decided_by = body.value("decided_by", Json());
    row.push_back(decided_by.is_string() ? decided_by.get<std::string>() : decided_by.dump());
    rows.push_back(std::move(row));
  }
  return absl::StrCat(
      "\n", water->size(), " ", title, "\n",
      Table({"level, m", "spread, m", "rim, m", "rim vertices", "area, m2", "cells", "decided by"}, rows));
}

}  // namespace tilemend
