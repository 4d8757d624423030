#include "client/report_text.h"

#include <algorithm>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "client/border_table.h"
#include "client/holes_table.h"
#include "client/left_table.h"
#include "client/output.h"
#include "client/water_table.h"
#include "common/util/text.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

constexpr size_t kMostTensions = 10;

std::string WarningsText(const Json& report) {
  const Json& warnings = Member(report, "warnings");
  if (!warnings.is_array() || warnings.empty()) return "";
  std::string text = absl::StrCat("\n", Counted(warnings.size(), "warning"), "\n");
  for (size_t i = 0; i < std::min(warnings.size(), kMostListedRows); ++i) {
    absl::StrAppend(&text, "  ", Printable(Text(warnings[i])), "\n");
  }
  return text + MoreText(warnings.size(), "see report.json");
}

// The original triangles that polygons with `clear` took out.
std::string ClearedText(const Json& report) {
  const Json& cleared = Member(report, "cleared");
  if (!cleared.is_object() || Number(Member(cleared, "triangles")) == 0) return "";
  Rows rows;
  for (const Json& area : Member(cleared, "areas")) {
    const Json& top = Member(area, "top_m");
    rows.push_back({Printable(Text(Member(area, "feature"))), Text(Member(area, "triangles")),
                    top.is_null() ? "any" : Decimals(top, 2)});
  }
  const size_t polygons = rows.size();
  if (rows.size() > kMostListedRows) rows.resize(kMostListedRows);
  return absl::StrCat("\n", Text(Member(cleared, "triangles")), " original triangles taken out\n",
                      Table({"polygon", "triangles", "up to, m"}, rows), MoreText(polygons, "see report.json"));
}

// What each level of detail got.
std::string LevelsText(const Json& report) {
  const Json& levels = Member(report, "levels");
  if (!levels.is_array() || levels.empty()) return "";
  Rows rows;
  for (const Json& level : levels) {
    std::vector<std::string>& row = rows.emplace_back();
    for (const char* name : {"level", "nodes", "filled", "added", "removed"}) row.push_back(Text(Member(level, name)));
  }
  return absl::StrCat("\n", Table({"level", "nodes", "filled", "triangles added", "removed"}, rows),
                      "level 0 is the coarsest.\n");
}

// "surface thin-plate, tension auto, ..."; switches that are off, and what was not given, are left out.
std::string OptionsText(const Json& options) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : options.items()) {
    const bool is_given = value != false && !(value.is_string() && Text(value).empty());
    if (is_given) parts.push_back(value == true ? name : absl::StrCat(name, " ", Text(value)));
  }
  return absl::StrJoin(parts, ", ");
}

std::string HeadText(const Json& report) {
  Rows rows;
  const auto add = [&rows](const char* name, const std::string& value) {
    if (!value.empty()) rows.push_back({name, value});
  };
  add("scene", Text(Member(report, "scene")));
  add("made", absl::StrCat(Text(Member(report, "date")), " by tilemend ", Text(Member(report, "version"))));
  add("options", OptionsText(Member(report, "options")));
  add("cells", Text(Member(report, "cells")));
  add("clusters", Text(Member(report, "clusters")));
  add("layers", Text(Member(report, "layers")));
  return Table({"report", ""}, rows);
}

// The tensions that were chosen from the rim; the error of a hold-out is there for information.
std::string TensionText(const Json& report) {
  const Json& choices = Member(report, "tension");
  if (!choices.is_array() || choices.empty()) return "";
  Rows rows;
  for (const Json& choice : choices) {
    if (!choice.is_object() || rows.size() == kMostTensions) continue;
    const char* kind = choice.contains("cluster") ? "cluster" : "hole";
    rows.push_back({absl::StrCat(kind, " ", Text(Member(choice, kind))),
                    absl::StrFormat("%.4g", Number(Member(choice, "tension"))),
                    Text(Member(choice, "hold_out_error_m")), Text(Member(choice, "steepness"))});
  }
  return absl::StrCat("\n", Counted(choices.size(), "tension"), " chosen from the rim\n",
                      Table({"", "tension, 1/m2", "hold-out error, m", "walls are steeper than"}, rows));
}

struct Figure {
  const char* path;  // of the report
  const char* words;
  int digits = 0;
};

constexpr Figure kFigures[] = {
    {"/single/simple", "closed holes: simple"},
    {"/single/crack", "closed holes: crack"},
    {"/single/dislocation", "closed holes: dislocation"},
    {"/single/annular", "closed holes: annular"},
    {"/single/island", "closed holes: island"},
    {"/continuous", "groups of holes that touch at a vertex"},
    {"/outer_rims", "outlines of detached pieces"},
    {"/quality/triangles", "triangles filled"},
    {"/quality/mean", "their shape, 0 to 1: mean", 2},
    {"/quality/fifth_percentile", "at 5 % below", 2},
    {"/quality/least", "worst", 4},
    {"/quality/poor", "of poor shape"},
    {"/quality/poor_forced_by_rim", "forced by the rim"},
};

std::string FiguresText(const Json& report) {
  Rows rows;
  for (const Figure& figure : kFigures) {
    const Json::json_pointer path(figure.path);
    if (!report.contains(path) || Number(report.at(path)) == 0) continue;
    rows.push_back({figure.words, Decimals(report.at(path), figure.digits)});
  }
  if (const Json& seconds = Member(report, "seconds"); seconds.is_object()) {
    for (const auto& [step, time] : seconds.items()) rows.push_back({absl::StrCat(step, ", s"), Decimals(time, 3)});
  }
  const Json& memory = Member(report, "peak_rss_bytes");
  if (memory.is_number()) rows.push_back({"peak memory, MB", absl::StrFormat("%.0f", Number(memory) / 1e6)});
  return rows.empty() ? "" : absl::StrCat("\n", Table({"figures", ""}, rows));
}

}  // namespace

std::string SummaryText(const Json& report, size_t columns) {
  return absl::StrCat(WarningsText(report), ClearedText(report), LevelsText(report), KindsText(report),
                      MethodsText(report), LargeHolesText(report, columns),
                      WaterText(report, "filled flat as water", columns), BordersText(report),
                      ReviewText(report, columns), LookAtText(report, columns), LeftText(report, "left", columns));
}

std::string ReportText(const Json& report, size_t columns) {
  return absl::StrCat(HeadText(report), SummaryText(report, columns), TensionText(report), FiguresText(report));
}

}  // namespace tilemend
