#include "coordinator/report/water_rows.h"

#include <algorithm>
#include <set>

#include "common/gis/property_names.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/rounded.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// Of a river: its level along the centreline, and the rises of its shores that it does not follow.
void AddRiver(const WaterBody& body, Json& row) {
  row["stations"] = Json::array();
  for (const Point3& s : body.river.stations) {
    row["stations"].push_back({Rounded(s.x(), 3), Rounded(s.y(), 3), Rounded(s.z(), 4)});
  }
  row["removed_rises"] = Json::array();
  for (const RemovedRise& r : body.removed_rises) {
    row["removed_rises"].push_back(
        {{"at", {Rounded(r.at.x(), 3), Rounded(r.at.y(), 3)}}, {"rise_m", Rounded(r.rise, 4)}});
  }
}

}  // namespace

Json LevelJson(const WaterBody& body) {
  const std::vector<Point3>& stations = body.river.stations;
  return stations.empty() ? Json(body.level) : Json{Rounded(stations.front().z(), 4), body.level};
}

Json WaterRows(const SceneReportInput& input) {
  Json rows = Json::array();
  for (size_t b = 0; b < input.plan->water.size(); ++b) {
    const WaterBody& body = input.plan->water[b];
    if (body.kind != BodyKind::kWater) continue;
    Json holes = Json::array();
    double area = 0;
    std::set<CellId> cells;
    for (const int32_t h : body.holes) {
      if (!FailureOf(input, h).empty()) continue;
      holes.push_back(h);
      area += input.plan->holes[h].area;
      cells.insert(input.plan->holes[h].cell);
    }
    if (holes.empty()) continue;
    const auto open = std::ranges::find_if(body.holes, [&](int32_t h) { return input.plan->holes[h].cluster >= 0; });
    Json row;
    if (open != body.holes.end()) row["cluster"] = input.plan->holes[*open].cluster;
    row.update({{"body", b},
                {"level_m", LevelJson(body)},
                {"sigma_m", body.level_is_given ? Json() : Json(Rounded(body.sigma, 4))},
                {"rim_m", {Rounded(body.lowest, 4), Rounded(body.highest, 4)}},
                {"rim_vertices", body.rim_vertices},
                {"area_m2", Rounded(area, 3)},
                {"cells", cells.size()},
                {"decided_by", body.forced ? kByArea : kByRim},
                {"kind", body.river.stations.empty() ? "lake" : "river"},
                {"holes", holes}});
    if (!body.river.stations.empty()) AddRiver(body, row);
    rows.push_back(row);
  }
  return rows;
}

Json WaterAreaRows(const Plan& plan) {
  Json rows = Json::array();
  for (const WaterAnswer& answer : plan.water_answers) {
    Json row = {{"feature", answer.label}, {"water", answer.water}, {"taken", answer.taken}};
    if (!answer.reason.empty()) row["reason"] = answer.reason;
    if (!answer.doubt.empty()) row["doubt"] = answer.doubt;
    if (answer.taken) row["holes"] = answer.holes;
    const int32_t body = answer.taken ? plan.holes[answer.holes.front()].water : -1;
    if (body >= 0) row["level_m"] = LevelJson(plan.water[body]);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace tilemend
