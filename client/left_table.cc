#include "client/left_table.h"

#include <algorithm>
#include <map>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/fitted_table.h"
#include "client/hole_columns.h"
#include "client/output.h"
#include "client/repeated_reasons.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/left_open.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// The rows of per_hole by their id.
std::map<std::string, const Json*> HolesById(const Json& report) {
  std::map<std::string, const Json*> holes;
  for (const Json& row : Member(report, "per_hole")) holes[Text(Member(row, "id"))] = &row;
  return holes;
}

Json SeenFromAbove(const Json& at) { return at.size() == 3 ? Json({at[0], at[1]}) : Json(); }

std::vector<std::string> Row(const Json& item, const std::map<std::string, const Json*>& holes,
                             const HoleColumns& columns) {
  const std::string id = Text(Member(item, "hole"));
  const auto it = holes.find(id);
  const Json nothing;
  const Json& hole = it == holes.end() ? nothing : *it->second;
  return {id,
          Text(Member(item, "cell")),
          CentreText(it == holes.end() ? SeenFromAbove(Member(item, "at")) : Member(hole, "centre")),
          columns.Area(hole),
          Text(Member(item, "open_edges")),
          Text(Member(item, "reason"))};
}

std::string NotHolesText(const Json& report, size_t columns) {
  std::vector<std::vector<std::string>> rows;
  for (const Json& row : Member(report, "not_holes")) {
    rows.push_back({Text(Member(row, "count")), Text(Member(row, "open_edges")), Text(Member(row, "what"))});
  }
  return rows.empty()
             ? ""
             : absl::StrCat("\nopen, but no holes\n", TableWithTexts({"number", "edges", "what"}, rows, columns));
}

// Of the boundary's vertices.
Point3 MiddleOf(const Plan& plan, const PlannedHole& hole) {
  Point3 sum = Point3::Zero();
  for (const RimSegment& s : hole.segments) sum += plan.vertices[s.from].position;
  return sum / static_cast<double>(hole.segments.size());
}

}  // namespace

std::string LeftText(const Json& report, const std::string& title, size_t terminal_columns) {
  std::vector<Json> items;
  for (const Json& item : Member(report, "left")) {
    if (item.is_object()) items.push_back(item);
  }
  std::stable_partition(items.begin(), items.end(), [](const Json& item) { return item.contains("hole"); });
  std::string text;
  if (!items.empty()) {
    const auto holes = HolesById(report);
    const HoleColumns columns(report);
    std::vector<std::vector<std::string>> rows;
    for (size_t i = 0; i < std::min(items.size(), kMostListedRows); ++i) rows.push_back(Row(items[i], holes, columns));
    ShortenRepeated(rows);
    absl::StrAppend(
        &text, "\n", items.size(), " ", title, "\n",
        columns.TableOf({"hole", "cell", "centre, m", "area, m2", "edges", "reason"}, rows, terminal_columns),
        MoreText(items.size(), "see `left` in the report"));
  }
  return text + NotHolesText(report, terminal_columns);
}

std::string LeftLines(const SceneReportInput& report) {
  std::vector<std::vector<std::string>> parts;  // where, why
  size_t chosen = 0;
  for (const LeftOpen& left : LeftOf(report)) {
    chosen += left.reason == kLongerThanChosen;
    if (!left.is_hole) continue;
    std::string where;
    if (left.hole >= 0) {
      const Point3 at = MiddleOf(*report.plan, report.plan->holes[left.hole]);
      where = absl::StrFormat(" around (%.6g, %.6g, %.6g)", at.x(), at.y(), at.z());
    } else if (left.at) {
      where = absl::StrFormat(", the first at (%.6g, %.6g, %.6g)", left.at->x(), left.at->y(), left.at->z());
    }
    parts.push_back({absl::StrCat("left: ", left.edges, " edges", where, ": "), left.reason});
  }
  ShortenRepeated(parts);
  std::string lines;
  for (const std::vector<std::string>& part : parts) absl::StrAppend(&lines, part[0], part[1], "\n");
  if (chosen > 0) absl::StrAppend(&lines, "left as chosen: ", Counted(chosen, "hole"), " ", kLongerThanChosen, "\n");
  return lines;
}

}  // namespace tilemend
