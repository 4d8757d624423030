// Polygons and lines that users draw in a GIS: GeoJSON and GeoPackage, by GDAL; coordinate systems by PROJ.
//
// GDAL brings more than a hundred shared libraries. So these sources are linked into a module of their own, which
// area_file.h loads when a file is to be read. Only plain types pass between the two.
#ifndef TILEMEND_COMMON_GIS_VECTOR_FILE_H_
#define TILEMEND_COMMON_GIS_VECTOR_FILE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/mesh/plane_polygon.h"

namespace tilemend {

// Where the scene's coordinates lie.
struct SceneFrame {
  std::string crs;         // of the scene: "EPSG:25832", "ENU:48.1,11.5", WKT or a PROJ string; empty: not known
  Point3 origin{0, 0, 0};  // of the scene's coordinates, in the CRS
  // Extent of the grid, scene coordinates. Without one (lo > hi) coordinates are those of the scene unless the file
  // names a CRS.
  Point2 lo{0, 0}, hi{-1, -1};
};

// A feature of the file, in metres relative to the scene's origin.
struct VectorFeature {
  std::string label;                                  // "feature 3 (Pond)", with its layer if there are several
  PlanePolygon polygon;                               // empty: the feature is a line
  std::vector<Point2> line;                           // of a polygon: its property `centreline`
  bool water = true;                                  // property `water`
  std::optional<double> level;                        // property `level_m`
  bool clear = false;                                 // property `clear`
  std::optional<double> clear_height = std::nullopt;  // property `clear_height`, metres, >= 0
};

struct VectorRequest {
  std::string_view bytes;  // of the file
  std::string name;        // of the file, for messages
  bool names_crs = true;   // false: GeoJSON without the member `crs`
  std::string crs_name;    // of GeoJSON that names one: as it does
  int64_t features = -1;   // that the file must have; -1: not known
  bool unite = false;      // one polygon of all; lines and outlines that cross are refused
  SceneFrame frame;
};

struct VectorFile {
  std::vector<VectorFeature> features;  // in the order of the file
  std::string coordinates;              // what they were taken for: "scene coordinates", "EPSG:25832", ...
  std::vector<std::string> warnings;
  std::string error;  // not empty: why there are none; begins with the name
};

// Reads Polygons, MultiPolygons and LineStrings of all layers. A polygon that is not valid is repaired, with a warning
// that names it and the place: what any of its parts surrounds is inside.
//
// What coordinates are. Those of a layer that names its CRS are transformed to the scene's. Others are taken for
// longitude and latitude (WGS 84), for coordinates of the scene, or of its CRS, in this order, whichever puts the layer
// into the scene; between the first two the better fit decides. Heights are never transformed: level_m is relative to
// the origin if coordinates are, else it is a height of the scene's CRS.
//
// Errors: bytes that are neither, a geometry of another kind or none, a ring with fewer than four positions or not
// closed, a coordinate that is no number or ends up beyond 1e9 m, a property of another type, a CRS that is not known,
// coordinates that cannot be those of this scene (also: that would be, with x and y exchanged).
VectorFile ReadVectors(const VectorRequest& request);

// The same, under a name that is found in the module.
extern "C" __attribute__((visibility("default"))) void TilemendReadVectors(const VectorRequest& request,
                                                                           VectorFile& file);

// What is wrong with the CRS of a scene, for people; "" if nothing is, or there is none.
std::string FaultOfCrs(const std::string& crs);
extern "C" __attribute__((visibility("default"))) void TilemendFaultOfCrs(const std::string& crs, std::string& fault);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_VECTOR_FILE_H_
