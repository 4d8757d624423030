#include "client/water_table.h"

#include <algorithm>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/fitted_table.h"
#include "client/output.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

double AreaOf(const Json& body) { return Number(Member(body, "area_m2")); }

// "3, 0.250 m at most", of the rises that a river's surface does not follow.
std::string RisesOf(const Json& body) {
  const Json& rises = Member(body, "removed_rises");
  double most = 0;
  for (const Json& rise : rises) most = std::max(most, Number(Member(rise, "rise_m")));
  return rises.empty() ? "" : absl::StrCat(rises.size(), ", ", absl::StrFormat("%.3f", most), " m at most");
}

std::string SigmaText(const Json& sigma) { return sigma.is_null() ? "given" : Decimals(sigma, 3); }

// The report says "area" of a water polygon; --area is another one.
std::string DecidedByText(const Json& body) {
  const std::string decider = Text(Member(body, "decided_by"));
  return decider == "area" ? "polygon" : decider;
}

std::vector<std::string> Row(const Json& body) {
  return {Text(Member(body, "kind")),
          LevelText(Member(body, "level_m")),
          AreaText(Member(body, "area_m2")),
          Text(Member(body, "cells")),
          SigmaText(Member(body, "sigma_m")),
          LevelText(Member(body, "rim_m")),
          Text(Member(body, "rim_vertices")),
          DecidedByText(body),
          RisesOf(body)};
}

// If no row has rises, their column is the first that a narrow terminal leaves out.
std::vector<FittedColumn> ColumnsFor(const std::vector<std::vector<std::string>>& rows) {
  const bool has_rises = std::ranges::any_of(rows, [](const auto& row) { return !row.back().empty(); });
  return {{"water"},           {"level, m"},   {"area, m2"},
          {"cells", 1},        {"sigma, m"},   {"rim, m"},
          {"rim vertices", 3}, {"decided by"}, {"rises removed", has_rises ? 2 : 4}};
}

}  // namespace

std::string WaterText(const Json& report, const std::string& title, size_t columns) {
  std::vector<Json> bodies;
  for (const Json& body : Member(report, "water")) {
    if (body.is_object()) bodies.push_back(body);
  }
  if (bodies.empty()) return "";
  std::stable_sort(bodies.begin(), bodies.end(), [](const Json& a, const Json& b) { return AreaOf(a) > AreaOf(b); });
  std::vector<std::vector<std::string>> rows;
  for (size_t i = 0; i < std::min(bodies.size(), kMostListedRows); ++i) rows.push_back(Row(bodies[i]));
  return absl::StrCat("\n", bodies.size(), " ", title, "\n", FittedTable(ColumnsFor(rows), rows, columns),
                      MoreText(bodies.size(), "see `water` in the report"));
}

}  // namespace tilemend
