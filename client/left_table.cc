#include "client/left_table.h"

#include <algorithm>
#include <map>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/output.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostRows = 50;

std::string Text(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json Member(const Json& object, const char* name) { return object.is_object() ? object.value(name, Json()) : Json(); }

// The rows of per_hole by their id.
std::map<std::string, Json> HolesById(const Json& report) {
  std::map<std::string, Json> holes;
  const Json rows = Member(report, "per_hole");
  for (const Json& row : rows) {
    if (row.is_object()) holes[Text(Member(row, "id"))] = row;
  }
  return holes;
}

bool IsOutline(const Json& item) { return Member(item, "expected") == true; }

bool IsHole(const Json& item) { return item.contains("hole"); }

std::vector<std::string> Row(const Json& item, const std::map<std::string, Json>& holes) {
  const std::string id = Text(Member(item, "hole"));
  const auto it = holes.find(id);
  const Json hole = it == holes.end() ? Json() : it->second;
  return {id,
          Text(Member(item, "cell")),
          Text(Member(hole, "centre")),
          Text(Member(hole, "area_m2")),
          Text(Member(item, "open_edges")),
          Text(Member(item, "reason"))};
}

}  // namespace

std::string LeftText(const Json& report, const std::string& title) {
  std::vector<Json> items;
  size_t outlines = 0;
  const Json left = Member(report, "left");
  if (!left.is_array()) return "";
  for (const Json& item : left) {
    if (IsOutline(item)) {
      ++outlines;
    } else if (item.is_object()) {
      items.push_back(item);
    }
  }
  std::stable_partition(items.begin(), items.end(), IsHole);
  std::string text;
  if (!items.empty()) {
    absl::StrAppend(&text, "\n", items.size(), " ", title, "\n");
    const auto holes = HolesById(report);
    std::vector<std::vector<std::string>> rows;
    for (size_t i = 0; i < std::min(items.size(), kMostRows); ++i) rows.push_back(Row(items[i], holes));
    text += Table({"hole", "cell", "centre, m", "area, m2", "edges", "reason"}, rows);
    if (items.size() > kMostRows) absl::StrAppend(&text, "and ", items.size() - kMostRows, " more\n");
  }
  if (outlines > 0) absl::StrAppend(&text, "\n", Counted(outlines, "outline"), " of detached pieces: no holes\n");
  return text;
}

}  // namespace tilemend
