#include "common/gis/raw_features.h"

#include <cpl_error.h>
#include <cpl_json.h>

#include <cmath>
#include <memory>
#include <utility>

#include "common/gis/property_names.h"
#include "common/mesh/outline_crossing.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr int kLeastPositions = 4;         // of a ring, the last being the first
constexpr size_t kMostOfName = 100;        // columns
constexpr double kMostClearHeight = 1000;  // metres
constexpr char kUnresolved[] = "the polygon crosses itself in a way that cannot be resolved";

using GeometryPtr = std::unique_ptr<OGRGeometry>;

[[noreturn]] void Refuse(const std::string& place, const std::string& what) { throw BadVectors{place + ": " + what}; }

std::vector<Point2> PointsOf(const OGRSimpleCurve& curve, const std::string& place) {
  std::vector<Point2> points;
  for (int i = 0; i < curve.getNumPoints(); ++i) {
    points.emplace_back(curve.getX(i), curve.getY(i));
    if (!points.back().allFinite()) Refuse(place, "position " + std::to_string(i) + " is no pair of numbers");
  }
  return points;
}

void AddRing(const OGRLinearRing& ring, const std::string& place, PlanePolygon& polygon) {
  if (ring.getNumPoints() < kLeastPositions) Refuse(place, "expected a ring of at least 4 positions");
  std::vector<Point2> points = PointsOf(ring, place);
  if (points.front() != points.back()) Refuse(place, "the ring is not closed: its last position is not its first");
  points.pop_back();
  polygon.rings.push_back(std::move(points));
}

void AddPolygon(const OGRPolygon& polygon, const std::string& place, PlanePolygon& to) {
  if (polygon.getExteriorRing() == nullptr) Refuse(place, "a polygon without rings");
  int index = 0;
  for (const OGRLinearRing* ring : polygon) AddRing(*ring, place + ", ring " + std::to_string(index++), to);
}

std::vector<Point2> LineOf(const OGRGeometry* geometry, const std::string& place) {
  if (geometry != nullptr && wkbFlatten(geometry->getGeometryType()) == wkbMultiLineString) {
    const OGRMultiLineString& lines = *geometry->toMultiLineString();
    if (lines.getNumGeometries() == 1) geometry = lines.getGeometryRef(0);
  }
  if (geometry == nullptr || wkbFlatten(geometry->getGeometryType()) != wkbLineString) {
    Refuse(place, "expected one LineString");
  }
  std::vector<Point2> points = PointsOf(*geometry->toLineString(), place);
  if (points.size() < 2) Refuse(place, "expected a line of at least 2 positions");
  return points;
}

// Without arcs.
void SetGeometry(const OGRGeometry& geometry, VectorFeature& feature) {
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPolygon:
      return AddPolygon(*geometry.toPolygon(), feature.label, feature.polygon);
    case wkbMultiPolygon:
      if (geometry.IsEmpty()) Refuse(feature.label, "a MultiPolygon without polygons");
      for (const OGRPolygon* part : *geometry.toMultiPolygon()) AddPolygon(*part, feature.label, feature.polygon);
      return;
    case wkbLineString:
    case wkbMultiLineString:
      feature.line = LineOf(&geometry, feature.label);
      return;
    default:
      Refuse(feature.label, std::string(geometry.getGeometryName()) + ": expected Polygon, MultiPolygon or LineString");
  }
}

// What GEOS finds wrong with a polygon, and where; "" if nothing.
std::string FaultOf(const OGRGeometry& geometry) {
  std::string fault;
  CPLPushErrorHandlerEx(
      [](CPLErr, CPLErrorNum, const char* text) { *static_cast<std::string*>(CPLGetErrorHandlerUserData()) = text; },
      &fault);
  const bool valid = geometry.IsValid();
  CPLPopErrorHandler();
  return valid ? "" : fault.empty() ? "not valid" : fault;
}

// Sets the polygon to what is meant if it is not valid, and says so; "" if it is.
std::string Repair(const OGRGeometry& geometry, Crossings crossings, VectorFeature& feature) {
  std::string fault = FaultOf(geometry);
  if (fault.empty()) return "";
  if (const auto crossing = FindCrossing(feature.polygon)) {
    fault = TextOf(*crossing);
    if (crossings == Crossings::kRefuse) Refuse(feature.label, fault + "; draw it so that no edges cross");
  }
  // Of parts that overlap all is inside, not what an odd number of them surrounds.
  const char* const options[] = {"METHOD=STRUCTURE", nullptr};
  const GeometryPtr valid(geometry.MakeValid(options));
  if (!valid || valid->IsEmpty()) Refuse(feature.label, fault + ", and it surrounds nothing; draw it again");
  feature.polygon = {};
  SetGeometry(*valid, feature);
  return feature.label + ": " + fault + "; it is taken as repaired: all that it surrounds is inside";
}

// The index of a property that is there and not null, or -1.
int FieldOf(const OGRFeature& feature, const char* name) {
  const int index = feature.GetFieldIndex(name);
  return index >= 0 && feature.IsFieldSetAndNotNull(index) ? index : -1;
}

bool BooleanOf(const OGRFeature& feature, const char* name, bool otherwise, const std::string& place) {
  const int index = FieldOf(feature, name);
  if (index < 0) return otherwise;
  const OGRFieldDefn& definition = *feature.GetFieldDefnRef(index);
  const int value = feature.GetFieldAsInteger(index);
  // GeoPackages from programs without booleans hold 0 and 1.
  if (definition.GetType() != OFTInteger || value < 0 || value > 1) {
    Refuse(place, std::string("property ") + name + ": expected true or false");
  }
  return value != 0;
}

std::optional<double> ClearHeightOf(const OGRFeature& feature, const std::string& place) {
  const int index = FieldOf(feature, kClearHeightProperty);
  if (index < 0) return std::nullopt;
  const OGRFieldDefn& definition = *feature.GetFieldDefnRef(index);
  const OGRFieldType type = definition.GetType();
  const bool number = type == OFTReal || type == OFTInteger64 || type == OFTInteger;
  const double height = number ? feature.GetFieldAsDouble(index) : -1;
  if (definition.GetSubType() == OFSTBoolean || !(height >= 0 && height <= kMostClearHeight)) {
    Refuse(place, "property clear_height: expected a number of metres from 0 to 1000");
  }
  return height;
}

std::optional<double> LevelOf(const OGRFeature& feature, const std::string& place) {
  const int index = FieldOf(feature, kLevelProperty);
  if (index < 0) return std::nullopt;
  const OGRFieldDefn& definition = *feature.GetFieldDefnRef(index);
  const OGRFieldType type = definition.GetType();
  const bool number = type == OFTReal || type == OFTInteger64 || type == OFTInteger;
  const double level = number ? feature.GetFieldAsDouble(index) : 0;
  if (!number || definition.GetSubType() == OFSTBoolean || !(std::abs(level) <= 1e5)) {
    Refuse(place, "property level_m: expected a height in metres");
  }
  return level;
}

// A GeoJSON LineString or its coordinates, or WKT.
std::vector<Point2> CentrelineOf(const OGRFeature& feature, const std::string& place) {
  const int index = FieldOf(feature, kCentrelineProperty);
  if (index < 0) return {};
  std::string text = feature.GetFieldAsString(index);
  if (text.starts_with('[')) text = R"({"type": "LineString", "coordinates": )" + text + "}";
  GeometryPtr geometry;
  if (text.starts_with('{')) {
    geometry.reset(OGRGeometryFactory::createFromGeoJson(text.c_str()));
  } else if (OGRGeometry* read = nullptr;
             OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &read) == OGRERR_NONE) {
    geometry.reset(read);
  }
  return LineOf(geometry.get(), place + ", property centreline");
}

using Combine = OGRGeometry* (OGRGeometry::*)(const OGRGeometry*) const;

// All of them together, by halves: one after another would take n^2 steps. Null where GEOS fails.
GeometryPtr Together(std::vector<GeometryPtr> parts, Combine combine) {
  if (parts.empty()) return std::make_unique<OGRMultiPolygon>();
  while (parts.size() > 1) {
    std::vector<GeometryPtr> halved;
    for (size_t i = 0; i + 1 < parts.size(); i += 2) {
      halved.emplace_back((parts[i].get()->*combine)(parts[i + 1].get()));
      if (halved.back() == nullptr) return nullptr;
    }
    if (parts.size() % 2 == 1) halved.push_back(std::move(parts.back()));
    parts = std::move(halved);
  }
  return std::move(parts.front());
}

// Null where GEOS fails.
GeometryPtr RegionOf(const PlanePolygon& polygon) {
  std::vector<GeometryPtr> parts;
  for (const std::vector<Point2>& points : polygon.rings) {
    auto ring = std::make_unique<OGRLinearRing>();
    for (const Point2& p : points) ring->addPoint(p.x(), p.y());
    ring->closeRings();
    OGRPolygon inside;
    inside.addRingDirectly(ring.release());
    parts.emplace_back(inside.MakeValid());
    if (parts.back() == nullptr) return nullptr;
  }
  return Together(std::move(parts), &OGRGeometry::SymDifference);
}

std::string LabelOf(const OGRFeature& feature, const std::string& prefix) {
  std::string label = prefix + "feature " + std::to_string(feature.GetFID());
  const int index = FieldOf(feature, "name");
  if (index >= 0) label += " (" + ShownName(feature.GetFieldAsString(index)) + ")";
  return label;
}

}  // namespace

std::string ShownName(const std::string& name) { return SqueezedTo(Printable(name), kMostOfName); }

RawFeatures RawFeaturesOf(OGRLayer& layer, const std::string& prefix, Crossings crossings) {
  RawFeatures read;
  for (const auto& feature : layer) {
    VectorFeature& raw = read.features.emplace_back();
    raw.label = LabelOf(*feature, prefix);
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry == nullptr) Refuse(raw.label, "no geometry, or none that can be read");
    const GeometryPtr linear(geometry->getLinearGeometry());  // arcs become chords
    if (linear) geometry = linear.get();
    SetGeometry(*geometry, raw);
    raw.water = BooleanOf(*feature, kWaterProperty, true, raw.label);
    raw.level = LevelOf(*feature, raw.label);
    raw.clear = BooleanOf(*feature, kClearProperty, false, raw.label);
    raw.clear_height = ClearHeightOf(*feature, raw.label);
    if (raw.polygon.empty()) continue;
    const std::string repaired = Repair(*geometry, crossings, raw);
    if (!repaired.empty()) read.warnings.push_back(repaired);
    raw.line = CentrelineOf(*feature, raw.label);
  }
  return read;
}

std::vector<std::string> NearMisses(OGRLayer& layer, const std::string& prefix) {
  std::vector<std::string> warnings;
  OGRFeatureDefn& definition = *layer.GetLayerDefn();
  for (int i = 0; i < definition.GetFieldCount(); ++i) {
    const char* const name = definition.GetFieldDefn(i)->GetNameRef();
    const std::string meant(PropertyMeantBy(name));
    if (meant.empty() || definition.GetFieldIndex(meant.c_str()) == i) continue;
    std::string first;
    int64_t count = 0;
    for (const auto& feature : layer) {
      const OGRGeometry* geometry = feature->GetGeometryRef();
      const bool is_area = geometry != nullptr && geometry->getDimension() == 2;
      if (!is_area || !feature->IsFieldSetAndNotNull(i) || FieldOf(*feature, meant.c_str()) >= 0) continue;
      if (++count == 1) first = LabelOf(*feature, prefix);
    }
    if (count == 0) continue;
    std::string warning = first;
    if (count > 1) warning += " and " + std::to_string(count - 1) + " more";
    warning += ": property '" + ShownName(name) + "' has no effect; the name that has is '" + meant + "'";
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

VectorFeature Unite(const std::vector<VectorFeature>& features) {
  if (features.size() == 1 && !features[0].polygon.empty()) return features[0];
  std::vector<GeometryPtr> parts;
  VectorFeature united;
  for (const VectorFeature& feature : features) {
    if (feature.polygon.empty()) Refuse(feature.label, "a line: expected Polygon or MultiPolygon");
    united.label = feature.label;
    parts.push_back(RegionOf(feature.polygon));
    if (parts.back() == nullptr) Refuse(feature.label, kUnresolved);
  }
  if (features.empty()) throw BadVectors{"holds no polygon"};
  const GeometryPtr all = Together(std::move(parts), &OGRGeometry::Union);
  if (all == nullptr) Refuse(united.label, kUnresolved);
  SetGeometry(*all, united);
  return united;
}

}  // namespace tilemend
