// Where a user says what is water and what is not.
#ifndef TILEMEND_COMMON_GRID_WATER_AREAS_H_
#define TILEMEND_COMMON_GRID_WATER_AREAS_H_

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/plane_polygon.h"

namespace tilemend {

// All in metres relative to the scene's origin, as the tiles' coordinates.
struct WaterArea {
  bool water = true;  // false: what it covers is no water
  PlanePolygon polygon = {};
  std::optional<double> level = std::nullopt;  // height of the water; none: from its shore
  std::vector<Point2> centreline = {};         // of a river, in either direction; empty or at least two points
  std::string label = {};                      // of the feature in the file, for people
};

// Reads GeoJSON (RFC 7946, but in scene coordinates): a Polygon or MultiPolygon, a Feature of one, or a
// FeatureCollection of such Features. Areas are in the order of the file. A Feature's property `water` may be true (as
// without it, or null) or false; other members are ignored, and so are third coordinates.
//
// kInvalidArgument with `name` and the place (byte and line, or members and indices): no JSON, another type, a ring
// with fewer than four positions or whose last is not its first, a coordinate that is no number or beyond 1e9 m.
absl::StatusOr<std::vector<WaterArea>> ParseWaterAreas(const std::string& text, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_WATER_AREAS_H_
