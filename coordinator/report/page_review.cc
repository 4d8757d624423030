#include "coordinator/report/page_review.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/store/gzip.h"
#include "common/util/status_macros.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/page_holes.h"
#include "coordinator/report/scene_member.h"
#include "coordinator/report/shallow_json.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// For each hole the item that it belongs to, by the item's own hole.
std::map<int64_t, int64_t> ItemsOfHoles(const Json& items) {
  std::map<int64_t, int64_t> item_of;
  for (const Json& item : items) {
    const Json& hole = Member(item, "hole");
    if (!hole.is_number_integer()) continue;
    for (const Json& part : Member(item, "holes")) {
      if (part.is_number_integer()) item_of[part.get<int64_t>()] = hole.get<int64_t>();
    }
  }
  return item_of;
}

const Json& HoleIn(const Json& feature) { return Member(Member(feature, "properties"), "hole"); }

// Whether a reviewer decided on the hole before.
bool IsDecided(const Json& feature) { return Member(Member(feature, "properties"), "decision").is_string(); }

// Holes with a fill that belong to no item.
std::set<int64_t> OthersOf(const Json& report, const std::map<int64_t, int64_t>& item_of) {
  std::set<int64_t> others;
  for (const Json& row : PageHoles(report, kMostOutlinedHoles)) {
    const Json& hole = Member(row, "id");
    if (Member(row, "filled") != true || !hole.is_number_integer() || item_of.contains(hole.get<int64_t>())) continue;
    others.insert(hole.get<int64_t>());
  }
  return others;
}

// holes.geojson without the features of holes that nobody decided on, and that are neither in an item nor others.
absl::StatusOr<Json> ReadHoles(const std::string& text, const std::map<int64_t, int64_t>& item_of,
                               const std::set<int64_t>& others, const std::stop_token& stop) {
  const auto is_wanted = [&](int depth, const Json& value) {
    if (depth != 2 || !value.contains("geometry")) return true;  // the CRS has an object at this depth as well
    const Json& hole = HoleIn(value);
    if (IsDecided(value)) return true;
    if (!hole.is_number_integer()) return false;
    return item_of.contains(hole.get<int64_t>()) || others.contains(hole.get<int64_t>());
  };
  Json json = ParseShallow(text, {.keep = is_wanted, .stop = stop});
  if (stop.stop_requested()) return absl::CancelledError("asked to end while holes.geojson was read");
  if (!json.is_object()) return absl::InvalidArgumentError("holes.geojson: not GeoJSON (expected an object)");
  return json;
}

bool HasPolygon(const Json& feature) {
  const Json &geometry = Member(feature, "geometry"), &type = Member(geometry, "type");
  return (type == "Polygon" || type == "MultiPolygon") && Member(geometry, "coordinates").is_array();
}

Json OutlineOf(const Json& feature) {
  return {{"hole", HoleIn(feature)},
          {"cluster", Member(Member(feature, "properties"), "cluster")},
          {"geometry", feature["geometry"]}};
}

// The polygons of each item, by its hole. Holes of an item may touch, so together they are no valid MultiPolygon.
Json OutlinesOf(const Json& holes, const std::map<int64_t, int64_t>& item_of) {
  Json outlines = Json::object();
  for (const Json& feature : Member(holes, "features")) {
    const Json& hole = HoleIn(feature);
    if (!hole.is_number_integer() || !Member(Member(feature, "geometry"), "coordinates").is_array()) continue;
    const auto item = item_of.find(hole.get<int64_t>());
    if (item == item_of.end()) continue;
    Json& parts = outlines[absl::StrCat(item->second)];
    if (HasPolygon(feature)) parts.push_back(OutlineOf(feature));
  }
  return outlines;
}

Json OutlinesOfOthers(const Json& holes, const std::set<int64_t>& others) {
  Json outlines = Json::object();
  for (const Json& feature : Member(holes, "features")) {
    const Json& hole = HoleIn(feature);
    if (!hole.is_number_integer() || !others.contains(hole.get<int64_t>()) || !HasPolygon(feature)) continue;
    outlines[absl::StrCat(hole.get<int64_t>())] = OutlineOf(feature);
  }
  return outlines;
}

// Whether `level_m` is that of a decision. What the run found at the shore has a standard deviation.
bool HasGivenLevel(const Json& properties) {
  return Member(properties, "decision") == "water" && Member(properties, "sigma_m").is_null();
}

// The features of earlier decisions, with what --decisions reads of them. What has no polygon is left out: no decision
// could have covered it.
Json EarlierOf(const Json& holes) {
  Json earlier = Json::array();
  for (const Json& feature : Member(holes, "features")) {
    if (!IsDecided(feature) || !HasPolygon(feature)) continue;
    const Json& decided = Member(feature, "properties");
    Json properties = Json::object();
    for (const char* name : {"hole", "cluster", "decision"}) properties[name] = Member(decided, name);
    properties["level_m"] = HasGivenLevel(decided) ? Member(decided, "level_m") : Json();
    earlier.push_back({{"type", "Feature"}, {"properties", std::move(properties)}, {"geometry", feature["geometry"]}});
  }
  return earlier;
}

absl::StatusOr<std::string> Packed(const Json& json) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, Gzip(json.dump()));
  return absl::Base64Escape(bytes);
}

}  // namespace

size_t FillsToDecideOn(const Json& report) {
  const Json& rows = Member(report, "review");
  return rows.is_array() ? rows.size() : 0;
}

absl::StatusOr<Json> PageReview(const Json& report, const std::string& holes, const Scene* scene,
                                const std::stop_token& stop) {
  const Json& rows = Member(report, "review");
  Json items = Json::array();
  const size_t count = FillsToDecideOn(report);
  for (size_t i = 0; i < std::min(count, kMostReviewItems); ++i) items.push_back(rows[i]);
  const std::map<int64_t, int64_t> item_of = ItemsOfHoles(items);
  const std::set<int64_t> others = OthersOf(report, item_of);
  TILEMEND_ASSIGN_OR_RETURN(const Json geojson, ReadHoles(holes, item_of, others, stop));
  TILEMEND_ASSIGN_OR_RETURN(std::string outlines, Packed(OutlinesOf(geojson, item_of)));
  TILEMEND_ASSIGN_OR_RETURN(std::string of_others, Packed(OutlinesOfOthers(geojson, others)));
  const Json decided = EarlierOf(geojson);
  TILEMEND_ASSIGN_OR_RETURN(std::string earlier, Packed(decided));
  return Json{{"count", count},
              {"items", std::move(items)},
              {"z", scene == nullptr ? Json() : Json(scene->origin.z())},
              {"crs", Member(geojson, "crs")},
              {"scene", Member(geojson, kSceneMember)},
              {"outlines", std::move(outlines)},
              {"others", std::move(of_others)},
              {"decided", decided.size()},
              {"earlier", std::move(earlier)}};
}

}  // namespace tilemend
