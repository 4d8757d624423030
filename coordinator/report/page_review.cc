#include "coordinator/report/page_review.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

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

// A fill that is in no item: the holes of a cluster, or one hole.
struct OtherFill {
  std::vector<int64_t> holes;
  double area = 0;  // m2
};

// Those of the holes that the page lists, the largest first.
std::vector<OtherFill> OthersOf(const Json& report, const std::map<int64_t, int64_t>& item_of) {
  std::vector<OtherFill> fills;
  std::map<int64_t, size_t> fill_of_cluster;
  for (const Json* row : ListedHoles(report, kMostListedHoles)) {
    const Json& hole = Member(*row, "id");
    if (IsLeftOpen(*row) || !hole.is_number_integer() || item_of.contains(hole.get<int64_t>())) continue;
    const int64_t cluster = ClusterOf(*row);
    const size_t fill = cluster < 0 ? fills.size() : fill_of_cluster.try_emplace(cluster, fills.size()).first->second;
    if (fill == fills.size()) fills.emplace_back();
    fills[fill].holes.push_back(hole.get<int64_t>());
    fills[fill].area += std::abs(Number(Member(*row, "area_m2")));
  }
  std::ranges::stable_sort(fills, std::greater<>(), &OtherFill::area);
  return fills;
}

std::set<int64_t> HolesOf(const std::vector<OtherFill>& fills) {
  std::set<int64_t> holes;
  for (const OtherFill& fill : fills) holes.insert(fill.holes.begin(), fill.holes.end());
  return holes;
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

size_t PositionsIn(const Json& coordinates) {
  if (!coordinates.is_array() || coordinates.empty()) return 0;
  if (coordinates.front().is_number()) return 1;
  size_t positions = 0;
  for (const Json& part : coordinates) positions += PositionsIn(part);
  return positions;
}

struct OtherOutlines {
  Json outlines = Json::object();     // `others` of PageReview
  std::vector<int64_t> without = {};  // `without_outline`
};

OtherOutlines OutlinesOfOthers(const Json& holes, const std::vector<OtherFill>& others) {
  std::map<int64_t, const Json*> features;
  for (const Json& feature : Member(holes, "features")) {
    const Json& hole = HoleIn(feature);
    if (hole.is_number_integer() && HasPolygon(feature)) features[hole.get<int64_t>()] = &feature;
  }
  OtherOutlines result;
  size_t room = kMostOutlinePositions;
  for (const OtherFill& fill : others) {
    std::vector<const Json*> outlines;
    size_t positions = 0;
    for (const int64_t hole : fill.holes) {
      const auto found = features.find(hole);
      if (found == features.end()) continue;
      outlines.push_back(found->second);
      positions += PositionsIn(found->second->at("geometry").at("coordinates"));
    }
    if (outlines.empty() || positions > room) {
      result.without.insert(result.without.end(), fill.holes.begin(), fill.holes.end());
      continue;
    }
    room -= positions;
    for (const Json* feature : outlines) {
      result.outlines[absl::StrCat(HoleIn(*feature).get<int64_t>())] = OutlineOf(*feature);
    }
  }
  return result;
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
  const std::vector<OtherFill> others = OthersOf(report, item_of);
  TILEMEND_ASSIGN_OR_RETURN(const Json geojson, ReadHoles(holes, item_of, HolesOf(others), stop));
  TILEMEND_ASSIGN_OR_RETURN(std::string outlines, Packed(OutlinesOf(geojson, item_of)));
  const OtherOutlines other_outlines = OutlinesOfOthers(geojson, others);
  TILEMEND_ASSIGN_OR_RETURN(std::string of_others, Packed(other_outlines.outlines));
  const Json decided = EarlierOf(geojson);
  TILEMEND_ASSIGN_OR_RETURN(std::string earlier, Packed(decided));
  return Json{{"count", count},
              {"items", std::move(items)},
              {"z", scene == nullptr ? Json() : Json(scene->origin.z())},
              {"crs", Member(geojson, "crs")},
              {"scene", Member(geojson, kSceneMember)},
              {"outlines", std::move(outlines)},
              {"others", std::move(of_others)},
              {"without_outline", other_outlines.without},
              {"decided", decided.size()},
              {"earlier", std::move(earlier)}};
}

}  // namespace tilemend
