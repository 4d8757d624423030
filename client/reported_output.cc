#include "client/reported_output.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDepth = 3;            // of lists around positions: those of a MultiPolygon
constexpr double kReachOfEdges = 5;  // metres around boundary edges in no loop, for each of them

std::optional<CellId> CellOf(const Json& row) {
  const Json& cell = Member(row, "cell");
  const bool valid = cell.is_array() && cell.size() == 2 && cell[0].is_number_integer() && cell[1].is_number_integer();
  if (!valid) return std::nullopt;
  return CellId{cell[0].get<int32_t>(), cell[1].get<int32_t>()};
}

std::optional<Point2> PlaneOf(const Json& place) {
  if (!place.is_array() || place.size() < 2 || !place[0].is_number() || !place[1].is_number()) return std::nullopt;
  return Point2(place[0].get<double>(), place[1].get<double>());
}

std::vector<Json> RowsOf(const Json& rows) {
  return rows.is_array() ? std::vector<Json>(rows.begin(), rows.end()) : std::vector<Json>();
}

double OverlapOf(const Json& borders) {
  double overlap = Number(Member(borders, "pieces_m"));
  for (const Json& border : RowsOf(Member(borders, "inexact"))) {
    for (const Json& margin : RowsOf(Member(border, "margins_m"))) overlap = std::max(overlap, Number(margin));
  }
  return overlap;
}

void AddWater(const Json& hole, ReportedOutput& reported) {
  const auto cell = CellOf(hole);
  const auto centre = PlaneOf(Member(hole, "centre"));
  const Json& level = Member(hole, "level_m");
  if (!cell || !centre || Member(hole, "method") != "water" || Member(hole, "outcome") != "filled") return;
  WaterHole fill{*centre, Number(level), Number(level)};
  if (level.is_array() && level.size() == 2) {
    const double a = Number(level[0]), b = Number(level[1]);
    fill.lowest = std::min(a, b);
    fill.highest = std::max(a, b);
  }
  reported.water[*cell].push_back({static_cast<int64_t>(Number(Member(hole, "id"))), fill});
}

void AddFilledArea(const Json& hole, ReportedOutput& reported) {
  if (const auto cell = CellOf(hole); cell && Member(hole, "outcome") == "filled") {
    reported.filled[*cell] += Number(Member(hole, "area_m2"));
  }
}

void AddFilledHeights(const Json& hole, ReportedOutput& reported) {
  if (Member(hole, "outcome") != "filled") return;
  std::vector<double> heights;
  for (const Json& value : {Member(hole, "rim_heights_m"), Member(hole, "level_m")}) {
    if (value.is_number()) heights.push_back(value.get<double>());
    for (const Json& height : RowsOf(value)) {
      if (height.is_number()) heights.push_back(height.get<double>());
    }
  }
  if (heights.empty()) return;
  const auto [lowest, highest] = std::ranges::minmax(heights);
  reported.filled_heights[static_cast<int64_t>(Number(Member(hole, "id")))] = {lowest, highest};
}

// Where tiles overlap, fills of open holes have walls at the outlines of the tiles, which may face down.
void AddHeightField(const Json& hole, ReportedOutput& reported) {
  const std::string method = Text(Member(hole, "method"));
  const bool is_over_ground = method == "over the ground" || method == "water" || method == "level ground";
  const bool has_walls = reported.overlap > 0 && Member(hole, "kind") != "closed";
  if (!is_over_ground || has_walls || Member(hole, "outcome") != "filled" || Member(hole, "folds_cut") == true) return;
  reported.height_fields.insert(static_cast<int64_t>(Number(Member(hole, "id"))));
}

LevelCounts LevelCountsOf(const Json& row) {
  const auto count = [&](const char* name) { return static_cast<int64_t>(Number(Member(row, name))); };
  return {count("nodes"), count("filled"), count("added"), count("removed")};
}

void AddLeftHole(const Json& hole, ReportedOutput& reported) {
  const auto cell = CellOf(hole);
  const auto centre = PlaneOf(Member(hole, "centre"));
  const Json& outcome = Member(hole, "outcome");
  if (!cell || !centre || (outcome != "left" && outcome != "not chosen")) return;
  const Json& place = Member(hole, "centre");
  const double height = Number(place.size() > 2 ? place[2] : Member(hole, "rim_height_m"));
  reported.left.push_back({.cell = *cell,
                           .at = {centre->x(), centre->y(), height},
                           .reach = Number(Member(hole, "perimeter_m")) / 2,
                           .hole = static_cast<int64_t>(Number(Member(hole, "id"))),
                           .reaches_border = Member(hole, "kind") != "closed",
                           .area = Number(Member(hole, "area_m2")),
                           .reason = Text(Member(hole, "reason"))});
}

// The rings, lists of positions, in coordinates that are at most so deep.
void AddRings(const Json& coordinates, const Point2& origin, int depth, std::vector<std::vector<Point2>>& rings) {
  std::vector<Point2> ring;
  for (const Json& item : RowsOf(coordinates)) {
    if (const auto position = PlaneOf(item)) {
      ring.emplace_back(*position - origin);
    } else if (depth > 1) {
      AddRings(item, origin, depth - 1, rings);
    }
  }
  if (ring.size() > 1) rings.push_back(std::move(ring));
}

}  // namespace

ReportedOutput ReadReported(const Json& report) {
  ReportedOutput reported;
  reported.overlap = OverlapOf(Member(report, "borders"));
  for (const Json& hole : RowsOf(Member(report, "per_hole"))) {
    AddWater(hole, reported);
    AddFilledArea(hole, reported);
    AddFilledHeights(hole, reported);
    AddHeightField(hole, reported);
    AddLeftHole(hole, reported);
  }
  for (const Json& row : RowsOf(Member(report, "left"))) {
    const auto cell = CellOf(row);
    const Json& place = Member(row, "at");
    const auto at = PlaneOf(place);
    if (!cell || !at || !Member(row, "hole").is_null()) continue;  // those of holes are above
    reported.left.push_back({.cell = *cell,
                             .at = {at->x(), at->y(), place.size() > 2 ? Number(place[2]) : 0},
                             .reach = kReachOfEdges * Number(Member(row, "open_edges")),
                             .reason = Text(Member(row, "reason"))});
  }
  for (const Json& row : RowsOf(Member(Member(report, "cleared"), "tiles"))) {
    if (const auto cell = CellOf(row))
      reported.cleared[*cell] += static_cast<int64_t>(Number(Member(row, "triangles")));
  }
  for (const Json& row : RowsOf(Member(report, "levels"))) reported.levels.push_back(LevelCountsOf(row));
  reported.has_textures = Text(Member(Member(report, "options"), "textures")) != "off";
  return reported;
}

void AddRims(const Json& holes, const Point2& origin, ReportedOutput& reported) {
  std::map<int64_t, std::vector<std::vector<Point2>>> rims;
  for (const ReportedOutput::Left& left : reported.left) {
    if (left.hole >= 0) rims[left.hole];
  }
  for (const Json& feature : RowsOf(Member(holes, "features"))) {
    const Json& number = Member(Member(feature, "properties"), "hole");
    const auto rim = number.is_number_integer() ? rims.find(number.get<int64_t>()) : rims.end();
    const Json& coordinates = Member(Member(feature, "geometry"), "coordinates");
    if (rim != rims.end()) AddRings(coordinates, origin, kDepth, rim->second);
    if (rim == rims.end() && Member(Member(feature, "properties"), "outcome") == "filled") {
      AddRings(coordinates, origin, kDepth, reported.filled_rims);
      const ReportedOutput::RimOwner owner{static_cast<int64_t>(Number(number)),
                                           Text(Member(Member(feature, "properties"), "cell"))};
      reported.filled_rim_owners.resize(reported.filled_rims.size(), owner);
    }
  }
  for (ReportedOutput::Left& left : reported.left) {
    if (left.hole >= 0) left.rim = rims[left.hole];
    for (const std::vector<Point2>& ring : left.rim) {
      for (const Point2& p : ring) left.box.extend(p);
    }
  }
}

}  // namespace tilemend
