// The files of --water, --area and --decisions.
#ifndef TILEMEND_COMMON_GIS_AREA_FILE_H_
#define TILEMEND_COMMON_GIS_AREA_FILE_H_

#include <stop_token>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/gis/vector_bytes.h"
#include "common/gis/vector_file.h"
#include "common/grid/scene.h"
#include "common/grid/water_areas.h"

namespace tilemend {

// Where a scene's coordinates lie. Of a single mesh (no cell size) nothing is known.
SceneFrame FrameOf(const Scene& scene);

// Whether the name of a CRS says that it is in metres. It is a zone of UTM by its code, or a place on Earth
// ("ENU:48.1,11.5"). Codes are EPSG:32601 to 32660 and 32701 to 32760 (WGS 84), and EPSG:25828 to 25838 (ETRS89).
bool IsInMetres(const std::string& crs);

// What is wrong with the CRS of a scene, for people; "" if nothing is. PROJ is asked unless the name tells. kInternal
// as below.
absl::StatusOr<std::string> CrsFaultOf(const Scene& scene, const std::stop_token& stop = {});

struct WaterFile {
  std::vector<WaterArea> areas;  // in the order of the file
  std::string coordinates;       // what those of the file were taken for, for people
  std::vector<std::string> warnings;
};

// Which polygons of a file have `clear`.
enum class ClearChoice { kByProperty, kAll };

// Reads a file of polygons in any of the formats of vector_file.h. A polygon is an area; its properties may be
//   water         true (the default) or false
//   level_m       a number, or text: "3.25 m"
//   kind          "lake" or "river"
//   clear         true or false; without effect with ClearChoice::kAll
//   clear_height  metres, 0 to 1000; only for water with `clear`, else there is a warning
//   centreline    a GeoJSON LineString or its coordinates, or WKT, in the coordinates of the file
// A LineString that is a feature of its own is the centreline of the area of water that most of its points are in.
// Dropped with a warning are centrelines of less than a metre, beside a level or `clear`, or of a lake. So is the kind
// of an area that is no water.
//
// kInvalidArgument with `name` and the place: what ReadVectors refuses, two centrelines for one area, a river with a
// level or `clear`. Errors of AskGdal. Takes some 40 ms more than the reading.
absl::StatusOr<WaterFile> ParseWaterFile(const VectorBytes& bytes, const std::string& name, const SceneFrame& frame,
                                         const std::stop_token& stop = {},
                                         ClearChoice clear = ClearChoice::kByProperty);

// Reads what was decided on holes: polygons with the property `decision` ("accept", "water", "ground" or "open"). They
// may have `level_m` (of water; absent: from its shore) and `hole` (for messages). Features without a decision are left
// out. All areas have a decision; kWater has `water` set. A file without features holds none, with a warning.
//
// Errors as above, with `name` and the feature; kInvalidArgument also for another word, for a decision on a line, and
// for features of which none has a decision.
absl::StatusOr<WaterFile> ParseDecisionFile(const VectorBytes& bytes, const std::string& name, const SceneFrame& frame,
                                            const std::stop_token& stop = {});

struct AreaFile {
  PlanePolygon area;  // not empty
  std::string coordinates;
  std::vector<std::string> warnings;
};

// Reads one area: all polygons of one layer of such a file, united. Lines are refused (of drawings left out),
// properties ignored.
absl::StatusOr<AreaFile> ParseAreaFile(const VectorBytes& bytes, const std::string& name, const SceneFrame& frame,
                                       const std::stop_token& stop = {});

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_AREA_FILE_H_
