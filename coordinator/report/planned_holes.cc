#include "coordinator/report/planned_holes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "absl/strings/str_cat.h"
#include "coordinator/report/hole_evidence.h"
#include "coordinator/report/page_holes.h"
#include "coordinator/report/review_queue.h"
#include "coordinator/report/rounded.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/report/water_rows.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// A row as report.json has it if all goes as planned.
Json RowOf(const Plan& plan, int32_t h) {
  const PlannedHole& hole = plan.holes[static_cast<size_t>(h)];
  Json row = {{"id", h},
              {"cell", {hole.cell.col, hole.cell.row}},
              {"centre", {Rounded(hole.centre.x(), kMillimetres), Rounded(hole.centre.y(), kMillimetres)}},
              {"kind", KindName(hole.kind)},
              {"area_m2", IsAreaKnown(hole) ? Json(Rounded(hole.area, kMillimetres)) : Json()},
              {"perimeter_m", Rounded(hole.perimeter, kMillimetres)},
              {"outcome", hole.failure.empty() ? "filled" : "left"},
              {"reason", hole.failure}};
  if (const char* type = TypeName(hole.type)) row["type"] = type;
  if (hole.water >= 0) row["level_m"] = LevelJson(plan.water[static_cast<size_t>(hole.water)]);
  if (hole.evidence >= 0) row["water"] = HoleEvidenceJson(plan.evidence[static_cast<size_t>(hole.evidence)]);
  if (const char* decision = DecisionOn(plan, h)) row["decision"] = decision;
  return row;
}

}  // namespace

std::string PlannedHolesJson(const Plan& plan, const std::set<CellId>& chosen, size_t most) {
  std::vector<int32_t> order;
  for (int32_t h = 0; h < static_cast<int32_t>(plan.holes.size()); ++h) {
    if (chosen.empty() || chosen.contains(plan.holes[static_cast<size_t>(h)].cell)) order.push_back(h);
  }
  std::ranges::stable_sort(order, [&](int32_t a, int32_t b) {
    const PlannedHole &x = plan.holes[static_cast<size_t>(a)], &y = plan.holes[static_cast<size_t>(b)];
    if (x.failure.empty() != y.failure.empty()) return y.failure.empty();
    return std::abs(x.area) > std::abs(y.area);
  });
  const size_t count = order.size();
  order.resize(std::min(count, most));
  Json rows = Json::array();
  for (const int32_t h : order) rows.push_back(RowOf(plan, h));
  const Json holes = {
      {"holeCount", count}, {"holes", PageHoles(Json{{"per_hole", std::move(rows)}}, most)}, {"planned", true}};
  return holes.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tilemend
