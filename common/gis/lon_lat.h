// Points of a CRS as longitudes and latitudes.
#ifndef TILEMEND_COMMON_GIS_LON_LAT_H_
#define TILEMEND_COMMON_GIS_LON_LAT_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Longitude and latitude of WGS 84 in degrees of each point (east, north in metres; `crs` as SceneFrame::crs).
// Returns kInvalidArgument with the CRS if PROJ does not know it, or if a point is none of it. Errors of AskGdal. Takes
// some 40 ms.
absl::StatusOr<std::vector<Point2>> LonLatOf(const std::string& crs, const std::vector<Point2>& points);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_LON_LAT_H_
