#include "common/grid/water_areas.h"

#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/grid/json_text.h"
#include "common/grid/scene_sources.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

using Json = nlohmann::json;

// A value in the file and its place there, for messages: "lakes.geojson: features[3].geometry".
struct Node {
  const Json& json;
  std::string place;

  absl::Status Error(const std::string& what) const {
    return absl::InvalidArgumentError(absl::StrCat(place, ": ", what));
  }
  Node operator[](size_t i) const { return {json[i], absl::StrCat(place, "[", i, "]")}; }
};

Node Root(const Json& json, const std::string& name) { return {json, absl::StrCat(name, ": GeoJSON")}; }

absl::StatusOr<Node> Member(const Node& node, const char* name) {
  if (!node.json.is_object()) return node.Error("expected an object");
  const auto it = node.json.find(name);
  if (it == node.json.end()) return node.Error(absl::StrCat("\"", name, "\" is missing"));
  return Node{*it, absl::StrCat(node.place, ".", name)};
}

absl::StatusOr<Node> ArrayMember(const Node& node, const char* name) {
  TILEMEND_ASSIGN_OR_RETURN(Node member, Member(node, name));
  if (!member.json.is_array()) return member.Error("expected an array");
  return member;
}

absl::StatusOr<std::string> TypeOf(const Node& node) {
  TILEMEND_ASSIGN_OR_RETURN(const Node type, Member(node, "type"));
  if (!type.json.is_string()) return type.Error("expected a text");
  return type.json.get<std::string>();
}

absl::StatusOr<Point2> ReadPosition(const Node& node) {
  const bool pair = node.json.is_array() && node.json.size() >= 2;
  if (!pair || !node.json[0].is_number() || !node.json[1].is_number()) return node.Error("expected [x, y]");
  const Point2 p(node.json[0].get<double>(), node.json[1].get<double>());
  if (!(p.cwiseAbs().maxCoeff() <= kMostMetres)) return node.Error("must be at most 1e9 m from the origin");
  return p;
}

absl::Status AddRing(const Node& node, WaterArea& area) {
  if (!node.json.is_array() || node.json.size() < 4) return node.Error("expected a ring of at least 4 positions");
  std::vector<Point2> ring;
  for (size_t i = 0; i < node.json.size(); ++i) {
    TILEMEND_ASSIGN_OR_RETURN(const Point2 p, ReadPosition(node[i]));
    ring.push_back(p);
  }
  if (ring.front() != ring.back()) return node.Error("the ring is not closed: its last position is not its first");
  ring.pop_back();
  area.polygon.rings.push_back(std::move(ring));
  return absl::OkStatus();
}

absl::Status AddPolygon(const Node& rings, WaterArea& area) {
  if (!rings.json.is_array() || rings.json.empty()) return rings.Error("expected an array of rings");
  for (size_t i = 0; i < rings.json.size(); ++i) TILEMEND_RETURN_IF_ERROR(AddRing(rings[i], area));
  return absl::OkStatus();
}

absl::StatusOr<WaterArea> ReadGeometry(const Node& geometry) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string type, TypeOf(geometry));
  if (type != "Polygon" && type != "MultiPolygon") {
    return geometry.Error(absl::StrCat("type \"", Printable(type), "\": expected Polygon or MultiPolygon"));
  }
  TILEMEND_ASSIGN_OR_RETURN(const Node coordinates, ArrayMember(geometry, "coordinates"));
  WaterArea area;
  if (type == "Polygon") {
    TILEMEND_RETURN_IF_ERROR(AddPolygon(coordinates, area));
    return area;
  }
  for (size_t i = 0; i < coordinates.json.size(); ++i) TILEMEND_RETURN_IF_ERROR(AddPolygon(coordinates[i], area));
  return area;
}

absl::StatusOr<bool> ReadWater(const Node& feature) {
  const auto properties = feature.json.find("properties");
  if (properties == feature.json.end() || !properties->is_object()) return true;
  const auto water = properties->find("water");
  if (water == properties->end() || water->is_null()) return true;
  if (!water->is_boolean()) {
    return absl::InvalidArgumentError(absl::StrCat(feature.place, ".properties.water: expected true or false"));
  }
  return water->get<bool>();
}

absl::StatusOr<WaterArea> ReadFeature(const Node& feature) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string type, TypeOf(feature));
  if (type != "Feature") return feature.Error(absl::StrCat("type \"", Printable(type), "\": expected Feature"));
  TILEMEND_ASSIGN_OR_RETURN(const Node geometry, Member(feature, "geometry"));
  TILEMEND_ASSIGN_OR_RETURN(WaterArea area, ReadGeometry(geometry));
  TILEMEND_ASSIGN_OR_RETURN(area.water, ReadWater(feature));
  return area;
}

}  // namespace

absl::StatusOr<std::vector<WaterArea>> ParseWaterAreas(const std::string& text, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const Json json, ParseJson(text, name));
  const Node root = Root(json, name);
  TILEMEND_ASSIGN_OR_RETURN(const std::string type, TypeOf(root));
  std::vector<WaterArea> areas;
  if (type != "FeatureCollection") {
    TILEMEND_ASSIGN_OR_RETURN(WaterArea area, type == "Feature" ? ReadFeature(root) : ReadGeometry(root));
    areas.push_back(std::move(area));
    return areas;
  }
  TILEMEND_ASSIGN_OR_RETURN(const Node features, ArrayMember(root, "features"));
  for (size_t i = 0; i < features.json.size(); ++i) {
    TILEMEND_ASSIGN_OR_RETURN(WaterArea area, ReadFeature(features[i]));
    areas.push_back(std::move(area));
  }
  return areas;
}

}  // namespace tilemend
