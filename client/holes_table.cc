#include "client/holes_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/fitted_table.h"
#include "client/hole_columns.h"
#include "client/output.h"
#include "client/repeated_reasons.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/page_review.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

constexpr char kLegend[] =
    "closed: inside one cell. I, II: over a grid line, counted in every cell;\n"
    "II reaches the rim of the area. In its cell a hole of type A leaves no surface,\n"
    "B one, C crosses it from side to side, D cuts off a corner or peninsula.\n";

constexpr std::ptrdiff_t kCrossingsColumn = 6;  // of the fills to decide on

struct Tally {
  int64_t holes = 0;
  int64_t filled = 0;
  double area = 0;  // of the filled ones
};

std::string KindOf(const Json& hole) {
  const std::string type = Text(Member(hole, "type"));
  return absl::StrCat(Text(Member(hole, "kind")), type.empty() ? "" : " ", type);
}

bool IsFilled(const Json& hole) { return Member(hole, "outcome") == "filled"; }

void Add(const Json& hole, Tally& tally) {
  ++tally.holes;
  if (!IsFilled(hole)) return;
  ++tally.filled;
  tally.area += std::abs(Number(Member(hole, "area_m2")));
}

std::vector<std::string> Row(const std::string& name, const Tally& tally, const HoleColumns& columns) {
  return {name, absl::StrCat(tally.holes), absl::StrCat(tally.filled), columns.Area(tally.area)};
}

// "lake at 3.250 m, sigma 0.020 m", "ground", or the level alone of a hole that was not judged.
std::string WaterOf(const Json& hole) {
  const Json &water = Member(hole, "water"), &level = Member(hole, "level_m");
  std::string at = level.is_null() ? "" : absl::StrCat("at ", LevelText(level), " m");
  if (water.is_null()) return at;
  std::string taken_for = Text(Member(water, "taken_for"));
  if (at.empty()) return taken_for;
  const Json& sigma = Member(water, "sigma_m");
  if (sigma.is_null()) return absl::StrCat(taken_for, " ", at);
  return absl::StrCat(taken_for, " ", at, ", sigma ", Decimals(sigma, 3), " m");
}

// "7", or of a row about several holes "7 and 3 more".
std::string HolesOf(const Json& row) {
  const std::string hole = Text(Member(row, "hole"));
  const Json& holes = Member(row, "holes");
  return holes.size() < 2 ? hole : absl::StrCat(hole, " and ", holes.size() - 1, " more");
}

// The numbers of all holes that a row is about. Those of one cluster may be named by another one of them elsewhere.
std::set<Json> HoleIdsOf(const Json& row) {
  const Json& holes = Member(row, "holes");
  std::set<Json> ids;
  if (holes.is_array()) ids.insert(holes.begin(), holes.end());
  if (const Json& hole = Member(row, "hole"); !hole.is_null()) ids.insert(hole);
  return ids;
}

// Of a volume, as AreaText; "" if it is not known.
std::string DoubtText(const Json& volume) { return volume.is_null() ? "" : AreaText(volume); }

using Reasons = std::map<Json, std::string>;  // by hole

// Why holes should be looked at.
Reasons ReasonsToLook(const Json& report) {
  Reasons why;
  for (const Json& item : Member(report, "look_at")) {
    for (const Json& hole : HoleIdsOf(item)) why[hole] = Text(Member(item, "why"));
  }
  return why;
}

// Why the holes of a row of `review` were taken for what they were, then why to look at them: as on the page
// (web/src/review.ts).
std::string BecauseOf(const Json& item, const Reasons& why) {
  std::vector<std::string> parts = {Text(Member(item, "reason"))};
  for (const Json& hole : HoleIdsOf(item)) {
    const auto found = why.find(hole);
    if (found == why.end() || found->second.empty()) continue;
    parts.push_back(found->second);
    break;
  }
  if (parts.front().empty()) parts.erase(parts.begin());
  return absl::StrJoin(parts, "; ");
}

// Those of per_hole that `is_wanted`, the largest first.
std::vector<const Json*> HolesByArea(const Json& report, const std::function<bool(const Json&)>& is_wanted) {
  std::vector<const Json*> holes;
  for (const Json& hole : Member(report, "per_hole")) {
    if (is_wanted(hole)) holes.push_back(&hole);
  }
  std::stable_sort(holes.begin(), holes.end(), [](const Json* a, const Json* b) {
    return Number(Member(*a, "area_m2")) > Number(Member(*b, "area_m2"));
  });
  return holes;
}

}  // namespace

std::string KindsText(const Json& report) {
  std::map<std::string, Tally> kinds;
  Tally all;
  for (const Json& hole : Member(report, "per_hole")) {
    if (!IsInChosenCell(hole)) continue;
    Add(hole, kinds[KindOf(hole)]);
    Add(hole, all);
  }
  if (kinds.empty()) return "";
  const HoleColumns columns(report);
  std::vector<std::vector<std::string>> rows;
  // "closed" is before "I" for a reader.
  if (const auto closed = kinds.extract("closed")) rows.push_back(Row(closed.key(), closed.mapped(), columns));
  for (const auto& [kind, tally] : kinds) rows.push_back(Row(kind, tally, columns));
  rows.push_back(Row("all", all, columns));
  return absl::StrCat("\n", Table({"kind of hole", "found", "filled", "area filled, m2"}, rows),
                      kinds.empty() ? "" : kLegend);
}

std::string MethodsText(const Json& report) {
  std::map<std::string, Tally> methods;
  for (const Json& hole : Member(report, "per_hole")) {
    const std::string method = Text(Member(hole, "method"));
    if (!method.empty()) Add(hole, methods[method]);
  }
  const HoleColumns columns(report);
  std::vector<std::vector<std::string>> rows;
  for (const auto& [method, tally] : methods) {
    rows.push_back({method, absl::StrCat(tally.filled), columns.Area(tally.area)});
  }
  return rows.empty() ? "" : absl::StrCat("\n", Table({"how filled", "holes", "area, m2"}, rows));
}

std::string LargeHolesText(const Json& report, size_t terminal_columns) {
  const std::vector<const Json*> holes =
      HolesByArea(report, [](const Json& hole) { return IsFilled(hole) && !Member(hole, "water").is_null(); });
  if (holes.empty()) return "";
  Rows rows;
  for (size_t i = 0; i < std::min(holes.size(), kMostListedRows); ++i) {
    const Json& hole = *holes[i];
    rows.push_back({Text(Member(hole, "id")), Text(Member(hole, "cell")), CentreText(Member(hole, "centre")),
                    AreaText(Member(hole, "area_m2")), WaterOf(hole), Text(Member(Member(hole, "water"), "reason"))});
  }
  ShortenRepeated(rows);
  return absl::StrCat(
      "\n", holes.size(),
      holes.size() == 1 ? " large hole or part of a large hole\n" : " large holes or parts of large holes\n",
      TableWithTexts({"hole", "cell", "centre, m", "area, m2", "filled as", "because"}, rows, terminal_columns),
      MoreText(holes.size(), "see `water` of per_hole in the report"));
}

std::string ReviewText(const Json& report, size_t terminal_columns) {
  const size_t count = FillsToDecideOn(report);
  if (count == 0) return "";
  const HoleColumns columns(report);
  const Reasons why = ReasonsToLook(report);
  std::vector<std::string> headings = {"hole",      "cell",      "centre, m", "area, m2",
                                       "taken for", "doubt, m3", "crossings", "because"};
  Rows rows;
  for (const Json& item : Member(report, "review")) {
    if (rows.size() == kMostListedRows || !item.is_object()) break;
    rows.push_back({HolesOf(item), Text(Member(item, "cell")), CentreText(Member(item, "centre")), columns.Area(item),
                    Text(Member(item, "taken_for")), DoubtText(Member(item, "doubt_m3")),
                    Text(Member(item, "crossings")), BecauseOf(item, why)});
  }
  ShortenRepeated(rows);
  if (std::ranges::all_of(rows, [](const auto& row) { return row[kCrossingsColumn].empty(); })) {
    headings.erase(headings.begin() + kCrossingsColumn);
    for (std::vector<std::string>& row : rows) row.erase(row.begin() + kCrossingsColumn);
  }
  return absl::StrCat("\n", Counted(count, "fill"), " to decide on\n", TableWithTexts(headings, rows, terminal_columns),
                      MoreText(count, "see `review` in the report"));
}

std::string LookAtText(const Json& report, size_t terminal_columns) {
  std::set<Json> queued;
  for (const Json& item : Member(report, "review")) queued.merge(HoleIdsOf(item));
  const auto is_queued = [&](const Json& hole) { return queued.contains(hole); };
  const HoleColumns columns(report);
  size_t places = 0;
  Rows rows;
  for (const Json& item : Member(report, "look_at")) {
    if (!item.is_object() || std::ranges::any_of(HoleIdsOf(item), is_queued) || ++places > kMostListedRows) continue;
    rows.push_back({HolesOf(item), Text(Member(item, "cell")), CentreText(Member(item, "centre")), columns.Area(item),
                    Text(Member(item, "why"))});
  }
  if (rows.empty()) return "";
  ShortenRepeated(rows);
  return absl::StrCat("\n", Counted(places, "place"), " to look at\n",
                      TableWithTexts({"hole", "cell", "centre, m", "area, m2", "why"}, rows, terminal_columns),
                      MoreText(places, "see `look_at` in the report"));
}

std::string PlannedHolesText(const Json& plan, size_t terminal_columns) {
  const std::vector<const Json*> holes =
      HolesByArea(plan, [](const Json& hole) { return Member(hole, "reason").is_null(); });
  if (holes.empty()) return "";
  const HoleColumns columns(plan);
  Rows rows;
  for (size_t i = 0; i < std::min(holes.size(), kMostListedRows); ++i) {
    const Json& hole = *holes[i];
    rows.push_back({Text(Member(hole, "id")), KindOf(hole), Text(Member(hole, "cell")),
                    CentreText(Member(hole, "centre")), columns.Area(hole), columns.Rim(hole), WaterOf(hole),
                    Text(Member(Member(hole, "water"), "reason"))});
  }
  ShortenRepeated(rows);
  return absl::StrCat(
      "\n", Counted(holes.size(), "hole"), " to fill, the largest first; filling may find some that stay open\n",
      columns.TableOf({"hole", "kind", "cell", "centre, m", "area, m2", "rim, m", "taken for", "because"}, rows,
                      terminal_columns),
      MoreText(holes.size(), "-o json lists all"));
}

}  // namespace tilemend
