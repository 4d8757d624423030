#include "coordinator/report/scene_geojson.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_split.h"
#include "common/gis/property_names.h"
#include "common/mesh/ring_polygons.h"
#include "common/mesh/winding/simple_rings.h"
#include "common/records/water_surface.h"
#include "coordinator/report/hole_evidence.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/review_queue.h"
#include "coordinator/report/ring_chains.h"
#include "coordinator/report/scene_member.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

std::string Dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

// What GDAL takes for the CRS: without any it would assume degrees.
std::string CrsName(const std::string& crs) {
  if (crs.empty()) return R"(LOCAL_CS["scene coordinates",UNIT["metre",1]])";
  if (absl::StartsWithIgnoreCase(crs, "EPSG:")) {
    const std::vector<std::string> parts = absl::StrSplit(crs.substr(5), '+');  // 25832+7837: with heights
    return absl::StrCat("urn:ogc:def:crs:EPSG::", parts[0]);
  }
  double latitude = 0, longitude = 0;
  if (std::sscanf(crs.c_str(), "ENU:%lf,%lf", &latitude, &longitude) != 2) return crs;
  return absl::StrFormat("+proj=ortho +lat_0=%.12f +lon_0=%.12f +datum=WGS84 +units=m +no_defs", latitude, longitude);
}

// In metres, in the scene's frame; none: without heights.
using HeightAt = std::function<double(const Point2&)>;

// Collects the features of one file.
class Features {
 public:
  explicit Features(const Scene& scene) : origin_(scene.origin) {
    const Json crs = {{"type", "name"}, {"properties", {{"name", CrsName(scene.crs)}}}};
    text_ = absl::StrCat("{\"type\": \"FeatureCollection\",\n\"crs\": ", Dump(crs), ",\n\"", kSceneMember,
                         "\": ", Dump(SceneMemberOf(scene)), ",\n\"features\": [");
  }

  // What `segments` wind around as polygons, with heights if given; as lines if that is nothing.
  void AddPolygons(const Plan& plan, const std::vector<RimSegment>& segments, Wound wound, const Json& properties,
                   const HeightAt& height = nullptr) {
    std::vector<std::vector<Point2>> rings;
    for (const std::vector<int32_t>& ring : RingsOf(segments)) {
      std::vector<Point2>& points = rings.emplace_back();
      for (const int32_t v : ring) points.emplace_back((plan.vertices[v].position + origin_).head<2>());
    }
    rings = SimpleRings(rings, wound);  // as they are written: rounding makes crossings, too
    if (rings.empty()) return AddSegments(plan, segments, properties);
    for (std::vector<Point2>& ring : rings) {
      for (Point2& p : ring) p -= origin_.head<2>();
    }
    AddRings(rings, properties, height);
  }

  void AddRings(const std::vector<std::vector<Point2>>& rings, const Json& properties,
                const HeightAt& height = nullptr) {
    if (rings.empty()) return;
    std::string polygons;
    const std::vector<RingPolygon> found = PolygonsOf(rings);
    for (const RingPolygon& polygon : found) {
      absl::StrAppend(&polygons, polygons.empty() ? "" : ", ", "[", Ring(rings[polygon.outline], height));
      for (const int32_t island : polygon.islands) absl::StrAppend(&polygons, ", ", Ring(rings[island], height));
      polygons += "]";
    }
    const bool single = found.size() == 1;
    Add(single ? "Polygon" : "MultiPolygon", absl::StrCat(single ? "" : "[", polygons, single ? "" : "]"), properties);
  }

  void AddLine(const std::vector<Point3>& line, const Json& properties) {
    std::string text;
    for (const Point3& point : line) {
      const Point3 p = point + origin_;
      absl::StrAppendFormat(&text, "%s[%.3f, %.3f, %.3f]", text.empty() ? "[" : ", ", p.x(), p.y(), p.z());
    }
    Add("LineString", text + "]", properties);
  }

  std::string Text() && { return absl::StrCat(text_, "\n]}\n"); }

 private:
  std::string Place(const Point2& p) const {
    return absl::StrFormat("%.3f, %.3f", p.x() + origin_.x(), p.y() + origin_.y());
  }

  std::string Ring(const std::vector<Point2>& ring, const HeightAt& height) const {
    std::string text = "[";
    for (size_t i = 0; i <= ring.size(); ++i) {
      const Point2& p = ring[i % ring.size()];
      absl::StrAppend(&text, i == 0 ? "[" : ", [", Place(p));
      if (height) absl::StrAppendFormat(&text, ", %.3f", height(p) + origin_.z());
      text += "]";
    }
    return text + "]";
  }

  // Of a hole that is not closed: where its rim is.
  void AddSegments(const Plan& plan, const std::vector<RimSegment>& segments, const Json& properties) {
    std::string lines;
    for (const RimSegment& s : segments) {
      if (s.seam) continue;
      absl::StrAppend(&lines, lines.empty() ? "[[" : ", [[", Place(plan.vertices[s.from].position.head<2>()), "], [",
                      Place(plan.vertices[s.to].position.head<2>()), "]]");
    }
    if (!lines.empty()) Add("MultiLineString", absl::StrCat("[", lines, "]"), properties);
  }

  void Add(const char* type, const std::string& coordinates, const Json& properties) {
    absl::StrAppend(&text_, first_ ? "\n" : ",\n", R"({"type": "Feature", "properties": )", Dump(properties),
                    R"(, "geometry": {"type": ")", type, R"(", "coordinates": )", coordinates, "}}");
    first_ = false;
  }

  const Point3 origin_;
  std::string text_;
  bool first_ = true;
};

double Millimetres(double value) { return std::round(value * 1000) / 1000; }

// The share of a hole's original boundary that stands on objects, by its length.
double ShareOnObjects(const Plan& plan, const PlannedHole& hole) {
  double whole = 0, on_objects = 0;
  for (const RimSegment& s : hole.segments) {
    if (s.seam) continue;
    const PlanVertex &a = plan.vertices[s.from], &b = plan.vertices[s.to];
    const double length = (a.position - b.position).norm();
    whole += length;
    if (a.on_object && b.on_object) on_objects += length;
  }
  return whole > 0 ? on_objects / whole : 0;
}

// As ParseWaterFile takes it.
const char* KindOf(const WaterBody& body) { return body.river.stations.empty() ? "lake" : "river"; }

// What the user's area says, so that the file says it again.
void AddAnswer(const WaterAnswer& answer, Json& row) {
  row["water"] = answer.water;
  if (!answer.clear_height) return;
  row["clear"] = true;
  if (answer.water) row["clear_height"] = *answer.clear_height;
}

// What a hole was taken for.
void AddWater(const Plan& plan, const PlannedHole& hole, double origin, Json& row) {
  if (hole.evidence >= 0) {
    const HoleEvidence& evidence = plan.evidence[hole.evidence];
    row[kTakenForProperty] = VerdictName(evidence.verdict);
    row["because"] = evidence.reason;
    if (evidence.has_level && evidence.sigma) row[kSigmaProperty] = Millimetres(*evidence.sigma);
    if (evidence.area >= 0) AddAnswer(plan.water_answers[evidence.area], row);
  }
  if (hole.water < 0) return;
  const WaterBody& body = plan.water[hole.water];
  if (body.river.stations.empty()) row[kLevelProperty] = body.level + origin;  // exact: it can be given back
  if (!body.level_is_given) {
    row[kEstimateProperty] = row[kLevelProperty];
    row[kSigmaProperty] = Millimetres(body.sigma);
  }
  row[kDecidedByProperty] = body.forced ? kByArea : kByRim;
  if (body.kind != BodyKind::kWater) return;
  row["water"] = true;
  row["kind"] = KindOf(body);
  if (hole.evidence < 0) row[kTakenForProperty] = KindOf(body);  // a small one beside others
  row["body"] = hole.water;
}

Json HoleProperties(const SceneReportInput& input, const Scene& scene, int32_t h) {
  const PlannedHole& hole = input.plan->holes[h];
  const std::string failure = FailureOf(input, h);
  Json row = {{"hole", h},
              {"cell", ToString(hole.cell)},
              {"hole_kind", KindName(hole.kind)},
              {"type", nullptr},
              {"cluster", nullptr},
              {"layer", nullptr},
              {"area_m2", IsAreaKnown(hole) ? Json(Millimetres(hole.area)) : Json()},
              {"perimeter_m", Millimetres(hole.perimeter)},
              {"outcome", OutcomeOf(failure)},
              {"reason", failure.empty() ? Json() : Json(failure)},
              {"method", nullptr},
              {"water", nullptr},
              {"kind", nullptr},
              {kLevelProperty, nullptr},
              {kEstimateProperty, nullptr},
              {kSigmaProperty, nullptr},
              {kDecidedByProperty, nullptr},
              {"clear", nullptr},
              {"clear_height", nullptr},
              {kTakenForProperty, nullptr},
              {"because", nullptr},
              {"body", nullptr},
              {"decision", nullptr},
              {"share_on_objects", Millimetres(ShareOnObjects(*input.plan, hole))}};
  if (const char* type = TypeName(hole.type)) row["type"] = type;
  if (hole.kind != HoleKind::kClosed) {
    row["cluster"] = hole.cluster;
    row["layer"] = hole.layer;
  }
  if (const char* decision = DecisionOn(*input.plan, h)) row["decision"] = decision;
  const auto size = input.outcome.sizes.find(h);
  if (size != input.outcome.sizes.end() && failure.empty())
    row["method"] = MethodOf(*input.plan, hole, size->second.way);
  AddWater(*input.plan, hole, scene.origin.z(), row);
  return row;
}

}  // namespace

std::string HolesGeoJson(const SceneReportInput& input, const Scene& scene) {
  Features features(scene);
  for (size_t h = 0; h < input.plan->holes.size(); ++h) {
    const auto id = static_cast<int32_t>(h);
    const PlannedHole& hole = input.plan->holes[h];
    // A hole in a wall or below a roof may be seen from either side.
    const Wound wound = hole.kind == HoleKind::kClosed ? Wound::kEither : Wound::kLeft;
    features.AddPolygons(*input.plan, hole.segments, wound, HoleProperties(input, scene, id));
  }
  return std::move(features).Text();
}

std::string BreaklinesGeoJson(const SceneReportInput& input, const Scene& scene) {
  const Plan& plan = *input.plan;
  Features features(scene);
  for (size_t w = 0; w < plan.water.size(); ++w) {
    std::vector<RimSegment> segments;
    double area = 0;
    for (const int32_t h : plan.water[w].holes) {
      if (!FailureOf(input, h).empty()) continue;
      segments.insert(segments.end(), plan.holes[h].segments.begin(), plan.holes[h].segments.end());
      area += plan.holes[h].area;
    }
    if (segments.empty() || plan.water[w].kind != BodyKind::kWater) continue;
    const std::vector<Point3>& stations = plan.water[w].river.stations;
    const Json level = plan.water[w].level + scene.origin.z();  // exact: it can be given back
    const Json highest = stations.empty() ? level : Json(Millimetres(stations.front().z() + scene.origin.z()));
    Json row = {{"line", "shore"},
                {"kind", KindOf(plan.water[w])},
                {"body", w},
                {"level_m", stations.empty() ? level : Json()},
                {"highest_m", highest},
                {"lowest_m", level},
                {"area_m2", Millimetres(area)}};
    features.AddPolygons(plan, segments, Wound::kLeft, row, [&](const Point2& p) {
      return stations.empty() ? plan.water[w].level : LevelAt(plan.water[w].river, p, plan.lattice_step);
    });
    if (stations.empty()) continue;
    row["line"] = "centreline";
    row["kind"] = nullptr;
    features.AddLine(stations, row);
  }
  return std::move(features).Text();
}

std::string ProposalsGeoJson(const Plan& plan, const std::vector<ProposedSurface>& surfaces, const Scene& scene) {
  Features features(scene);
  int64_t proposed = 0;
  const auto properties = [&](const char* name, const char* kind, double level, double sigma, double area, bool clear,
                              const std::string& reason) {
    return Json{{"name", absl::StrCat(name, " ", ++proposed)},
                {"water", true},
                {"kind", kind == nullptr ? Json() : Json(kind)},
                {"level_m", nullptr},
                {"clear", clear},
                {"proposed_level_m", Millimetres(level + scene.origin.z())},
                {"sigma_m", Millimetres(sigma)},
                {"area_m2", std::round(area)},
                {"reason", reason}};
  };
  for (const WaterBody& body : plan.water) {
    std::vector<RimSegment> segments;
    double area = 0;
    for (const int32_t h : body.holes) {
      segments.insert(segments.end(), plan.holes[h].segments.begin(), plan.holes[h].segments.end());
      area += plan.holes[h].area;
    }
    const bool is_water = body.kind == BodyKind::kWater;
    if (!is_water && area < kWaterProfiles[0].least_lake) continue;
    features.AddPolygons(
        plan, segments, Wound::kLeft,
        properties(is_water ? "water" : "level", is_water ? KindOf(body) : "lake", body.level, body.sigma, area, false,
                   is_water ? "a hole whose rim tells the level of water" : "a large level hole; it may be dry"));
  }
  for (const ProposedSurface& s : surfaces) {
    features.AddRings(s.outline.rings, properties("surface", nullptr, s.level, s.sigma, s.area, true, s.reason));
  }
  return std::move(features).Text();
}

std::string AreaGeoJson(const PlanePolygon& area, const Scene& scene) {
  Features features(scene);
  features.AddRings(area.rings, Json::object());
  return std::move(features).Text();
}

}  // namespace tilemend
