// Polygons and lines that users draw in a GIS or a CAD program, read by GDAL; coordinate systems by PROJ.
//
// GDAL brings more than a hundred shared libraries, and reads files of others. So these sources make a program of their
// own, which area_file.h starts when a file is to be read (gdal_process.h).
#ifndef TILEMEND_COMMON_GIS_VECTOR_FILE_H_
#define TILEMEND_COMMON_GIS_VECTOR_FILE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/grid/water_areas.h"
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
  std::string label;                                 // "feature 3 (Pond)", with its layer if there are several
  PlanePolygon polygon;                              // empty: the feature is a line
  std::vector<Point2> line;                          // of a polygon: its property `centreline`
  bool water = true;                                 // property `water`
  std::optional<double> level;                       // property `level_m`
  WaterKind kind = WaterKind::kUnsaid;               // property `kind`
  bool clear = false;                                // property `clear`
  std::optional<double> clear_height;                // property `clear_height`, metres, >= 0
  std::optional<double> level_sigma = std::nullopt;  // of a hole in holes.geojson whose level is still the estimate
  std::optional<int64_t> cluster = std::nullopt;     // of a hole in holes.geojson, while its file is read: not sent
  bool was_water = false;                            // of such a hole, likewise
  bool is_as_found = false;                          // of such a hole, that of its water nothing was changed
  std::optional<int64_t> body;      // of a hole in holes.geojson: property `body`; of a decision `cluster`
  std::vector<int64_t> holes = {};  // of a decision: property `hole` of each feature that is part of it
  ReviewDecision decision = ReviewDecision::kNone;  // property `decision`
};

// How the bytes begin. Of kOther GDAL finds out the format, with the help of the suffix.
enum class VectorFormat { kGeoJson, kGeoPackage, kArchive, kOther };

// A file that GDAL sees, in a folder of its own in memory.
struct MemoryPart {
  std::string name;  // "polygons.shp"; may begin with the name of a folder: "polygons.gdb/gdb"
  std::string_view bytes;
};

// What a file is read for.
enum class VectorUse {
  kWater,
  kArea,       // one polygon of all; lines and outlines that cross are refused, properties ignored
  kDecisions,  // only features with a property `decision` count, and no property of water
};

struct VectorRequest {
  VectorFormat format = VectorFormat::kOther;
  std::string opened;             // the name that GDAL opens: that of a part, or of a folder of parts
  std::vector<MemoryPart> parts;  // of the file
  std::string name;               // of the file, for messages
  bool names_crs = true;          // false: GeoJSON without the member `crs`
  std::string crs_name;           // of GeoJSON that names one: as it does
  int64_t features = -1;          // that the file must have; -1: not known
  VectorUse use = VectorUse::kWater;
  SceneFrame frame;
};

struct VectorFile {
  std::vector<VectorFeature> features;  // in the order of the file
  std::string coordinates;              // what they were taken for: "scene coordinates", "EPSG:25832", ...
  std::vector<std::string> warnings;
  std::string error;  // not empty: why there are none; begins with the name
};

// Reads Polygons, MultiPolygons and LineStrings of all layers, and of all files in an archive. A polygon that is not
// valid is repaired, with a warning that names it and the place: what any of its parts surrounds is inside. Of drawings
// (DXF, DGN) closed lines are polygons and nothing else is read. Other geometries are left out, with one warning that
// counts them.
//
// Formats: GeoJSON, GeoPackage, ESRI Shapefile and File Geodatabase, KML, GML, FlatGeobuf, MapInfo, DXF, DGN. In a ZIP
// archive (or KMZ) all of these but the first two. No other driver of GDAL is registered: none that opens a further
// file or a URL that its input names.
//
// holes.geojson: features with a property `hole` are left out, with one warning that counts them, unless they have a
// value of `water`, or a changed feature of the same `cluster` has one and none there is water as found. Those of one
// `body` that say the same are parts of one feature.
//
// What coordinates are. Those of a layer that names its CRS are transformed to the scene's. If the scene's CRS has the
// same code, but is another one, they are taken for the scene's if they lie in it, with a warning. Others are taken for
// longitude and latitude (WGS 84), for coordinates of the scene, or of its CRS. The first of these that puts the layer
// into the scene is taken; between the first two the better fit decides. Heights are never transformed: level_m is
// relative to the origin if coordinates are, else it is a height of the scene's CRS.
//
// Errors: bytes of no such format, a geometry that cannot be read, a ring with fewer than four positions or not
// closed. A coordinate that is no number or ends up beyond 1e9 m. A property of another type or value. A CRS that is
// not known. Coordinates that cannot be those of this scene (also: that would be, with x and y exchanged). For
// kDecisions: features of which none is a decision.
VectorFile ReadVectors(const VectorRequest& request);

// What is wrong with the CRS of a scene, for people; "" if nothing is, or there is none.
std::string FaultOfCrs(const std::string& crs);

// Moves points of a CRS to longitude and latitude of WGS 84, degrees. False if PROJ cannot.
bool ToLonLat(const std::string& crs, std::vector<Point2>& points);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_VECTOR_FILE_H_
