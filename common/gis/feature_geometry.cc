#include "common/gis/feature_geometry.h"

#include <cpl_error.h>

#include <utility>

#include "common/mesh/outline_crossing.h"

namespace tilemend {
namespace {

constexpr int kLeastPositions = 4;  // of a ring, the last being the first
constexpr char kUnresolved[] = "the polygon crosses itself in a way that cannot be resolved";

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

}  // namespace

void Refuse(const std::string& place, const std::string& what) { throw BadVectors{place + ": " + what}; }

bool IsAreaOrLine(const OGRGeometry& geometry) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  return type == wkbPolygon || type == wkbMultiPolygon || type == wkbLineString || type == wkbMultiLineString;
}

GeometryPtr AreaWithin(const OGRGeometry& geometry) {
  if (wkbFlatten(geometry.getGeometryType()) != wkbLineString) return nullptr;
  const OGRLineString& line = *geometry.toLineString();
  if (line.getNumPoints() < kLeastPositions || line.get_IsClosed() == 0) return nullptr;
  auto polygon = std::make_unique<OGRPolygon>();
  auto ring = std::make_unique<OGRLinearRing>();
  ring->addSubLineString(&line);
  polygon->addRingDirectly(ring.release());
  return polygon;
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

std::string Repair(const OGRGeometry& geometry, Crossings crossings, VectorFeature& feature) {
  std::string fault = FaultOf(geometry);
  if (fault.empty()) return fault;
  if (const auto crossing = FindCrossing(feature.polygon)) {
    fault = TextOf(*crossing);
    if (crossings == Crossings::kRefuse) Refuse(feature.label, fault + "; draw it so that no edges cross");
  }
  // Of parts that overlap all is inside, not what an odd number of them surrounds.
  const char* const options[] = {"METHOD=STRUCTURE", nullptr};
  const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);  // GEOS runs out of memory where too many edges cross
  const GeometryPtr valid(geometry.MakeValid(options));
  if (!valid) Refuse(feature.label, fault + ", and too many other edges cross to repair it; draw it again");
  if (valid->IsEmpty()) Refuse(feature.label, fault + ", and it surrounds nothing; draw it again");
  feature.polygon = {};
  SetGeometry(*valid, feature);
  return fault;
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
