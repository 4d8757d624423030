#include "client/page_data.h"

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "client/csv.h"
#include "common/grid/cell_choice.h"
#include "coordinator/report/changed_options.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/page_holes.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// Of what is left open those that are no hole of per_hole.
std::vector<const Json*> LooseRowsOf(const Json& report) {
  std::vector<const Json*> rows;
  const Json& left = Member(report, "left");
  if (!left.is_array()) return rows;
  for (const Json& row : left) {
    if (Member(row, "hole").is_null()) rows.push_back(&row);
  }
  return rows;
}

// The cells that the job was to write; empty: all, or not known without the scene.
std::set<CellId> CellsOfJob(const Json& report, const Scene* scene) {
  if (scene == nullptr) return {};
  const auto chosen = ChooseCells(Text(Member(Member(report, "options"), "cells")), *scene);
  return chosen.ok() ? *chosen : std::set<CellId>();
}

// [column, row, holes filled, holes left, whether it has a tile, how many of those left count] of each cell that was
// chosen.
Json CellsJson(const Json& report, const Scene* scene) {
  struct Counts {
    int64_t filled = 0, left = 0, counting = 0;
    bool has_tile = true;
  };
  std::map<std::pair<int32_t, int32_t>, Counts> cells;  // by row, column
  if (scene != nullptr) {
    const std::set<CellId> chosen = CellsOfJob(report, scene);
    for (const SceneTile& tile : scene->tiles) {
      if (!chosen.empty() && !chosen.contains(tile.cell)) continue;
      cells[{tile.cell.row, tile.cell.col}].has_tile = !tile.path.empty();
    }
  }
  const auto count = [&](const Json& row, int64_t filled, int64_t left, bool counts_as_left) {
    const Json& cell = Member(row, "cell");
    if (!cell.is_array() || cell.size() != 2 || !cell[0].is_number_integer() || !cell[1].is_number_integer()) return;
    Counts& counts = cells[{cell[1].get<int32_t>(), cell[0].get<int32_t>()}];
    counts.filled += filled;
    counts.left += left;
    counts.counting += counts_as_left ? 1 : 0;
  };
  for (const Json* hole : ChosenHoles(report)) {
    count(*hole, IsLeftOpen(*hole) ? 0 : 1, IsLeftOpen(*hole) ? 1 : 0, CountsAsLeft(*hole));
  }
  for (const Json* row : LooseRowsOf(report)) count(*row, 0, 1, true);
  Json rows = Json::array();
  for (const auto& [at, counts] : cells) {
    rows.push_back({at.second, at.first, counts.filled, counts.left, counts.has_tile ? 1 : 0, counts.counting});
  }
  return rows;
}

// "1 of 4 cells was chosen"; "" if all were.
std::string ChosenText(const Json& report, const Scene* scene) {
  const size_t chosen = CellsOfJob(report, scene).size();
  if (chosen == 0 || chosen == scene->tiles.size()) return "";
  return absl::StrCat(chosen, " of ", scene->tiles.size(), " cells ", chosen == 1 ? "was" : "were", " chosen");
}

// Of the holes in the cells that were chosen. `counting`: those left open that make the output partial.
Json VerdictJson(const Json& report, const Scene* scene) {
  const auto loose = static_cast<int64_t>(LooseRowsOf(report).size());
  int64_t filled = 0, left = loose, counting = loose;
  for (const Json* hole : ChosenHoles(report)) {
    filled += IsLeftOpen(*hole) ? 0 : 1;
    left += IsLeftOpen(*hole) ? 1 : 0;
    counting += CountsAsLeft(*hole) ? 1 : 0;
  }
  return {{"filled", filled},
          {"left", left},
          {"counting", counting},
          {"uncounted", UncountedText(report)},
          {"chosen", ChosenText(report, scene)}};
}

Json PicturesJson(const PagePictures& pictures) {
  Json rows = Json::array();
  for (const PagePicture& picture : pictures.pictures) {
    rows.push_back({{"hole", picture.hole},
                    {"triangles", picture.triangles},
                    {"coarser", picture.coarser},
                    {"bytes", absl::Base64Escape(picture.bytes)}});
  }
  return rows;
}

}  // namespace

Json PageData(const Json& report, const Scene* scene, const PagePictures& pictures) {
  Json data = Json::object();
  for (const char* name : {"version", "date", "scene", "options", "warnings", "holes", "filled", "water", "look_at",
                           "left", "not_holes", "cleared", "levels", "seconds"}) {
    data[name] = Member(report, name);
  }
  data["cells"] = CellsJson(report, scene);
  data["verdict"] = VerdictJson(report, scene);
  data["grid"] = scene == nullptr ? Json()
                                  : Json{{"crs", scene->crs},
                                         {"cell_size", {scene->grid.cell_size.x(), scene->grid.cell_size.y()}},
                                         {"corner", {scene->grid.corner.x(), scene->grid.corner.y()}}};
  data["hole_count"] = ChosenHoles(report).size();
  data["per_hole"] = PageHoles(report, kMostListedHoles);
  data["pictures"] = PicturesJson(pictures);
  data["picture_problems"] = pictures.problems;
  data["tasks"] = Member(report, "tasks");
  data["changed_options"] = ChangedOptions(report);
  return data;
}

std::string HolesCsv(const Json& report) {
  std::string text =
      "id,column,row,x,y,kind,type,single,area_m2,perimeter_m,outcome,method,level_m,sigma_m,taken_for,doubt_m3,"
      "crossings,decision,reason\r\n";
  for (const Json& hole : HoleRowsOf(report)) {
    const Json &cell = Member(hole, "cell"), &centre = Member(hole, "centre"), &water = Member(hole, "water");
    const auto entry = [](const Json& list, size_t k) {
      return list.is_array() && list.size() > k ? Text(list[k]) : std::string();
    };
    const Json& level = Member(hole, "level_m");
    const std::string level_text =
        level.is_array() ? absl::StrCat(entry(level, 0), " to ", entry(level, 1)) : Text(level);
    std::string line;
    for (const std::string& field :
         {Text(Member(hole, "id")), entry(cell, 0), entry(cell, 1), entry(centre, 0), entry(centre, 1),
          Text(Member(hole, "kind")), Text(Member(hole, "type")), Text(Member(hole, "single")),
          Text(Member(hole, "area_m2")), Text(Member(hole, "perimeter_m")), Text(Member(hole, "outcome")),
          Text(Member(hole, "method")), level_text, Text(Member(water, "sigma_m")), Text(Member(water, "taken_for")),
          Text(Member(hole, "doubt_m3")), Text(Member(hole, "crossings")), Text(Member(hole, "decision")),
          HoleReasonOf(hole)}) {
      absl::StrAppend(&line, line.empty() ? "" : ",", CsvField(field));
    }
    absl::StrAppend(&text, line, "\r\n");
  }
  return text;
}

}  // namespace tilemend
