// Geometries of GDAL as plain polygons and lines, checked.
#ifndef TILEMEND_COMMON_GIS_FEATURE_GEOMETRY_H_
#define TILEMEND_COMMON_GIS_FEATURE_GEOMETRY_H_

#include <ogrsf_frmts.h>

#include <memory>
#include <string>
#include <vector>

#include "common/gis/vector_file.h"

namespace tilemend {

using GeometryPtr = std::unique_ptr<OGRGeometry>;

// Why a file cannot be read.
struct BadVectors {
  std::string what;
};

// Throws BadVectors: "`place`: `what`".
[[noreturn]] void Refuse(const std::string& place, const std::string& what);

// Polygons and lines, simple or multiple; nothing else can be set.
bool IsAreaOrLine(const OGRGeometry& geometry);

// The polygon that a closed line bounds; null for others.
GeometryPtr AreaWithin(const OGRGeometry& geometry);

// The positions of a line, or of a MultiLineString with one part. Throws BadVectors with `place`.
std::vector<Point2> LineOf(const OGRGeometry* geometry, const std::string& place);

// Sets the polygon or the line of a feature. The geometry has no arcs. Throws BadVectors with the feature's label.
void SetGeometry(const OGRGeometry& geometry, VectorFeature& feature);

// Polygons that cross themselves or each other are errors of an area, and are repaired in water.
enum class Crossings { kRepair, kRefuse };

// Sets the polygon of a feature to what is meant if `geometry`, which it is from, is not valid: what any part surrounds
// is inside. Returns what was wrong and where, "" if nothing. Throws BadVectors.
std::string Repair(const OGRGeometry& geometry, Crossings crossings, VectorFeature& feature);

// All polygons as one, with the label of the last. Throws BadVectors if there is a line, or no polygon.
VectorFeature Unite(const std::vector<VectorFeature>& features);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_FEATURE_GEOMETRY_H_
