// Where a user says what is water, what is not, and what was decided on holes.
#ifndef TILEMEND_COMMON_GRID_WATER_AREAS_H_
#define TILEMEND_COMMON_GRID_WATER_AREAS_H_

#include <optional>
#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "common/mesh/plane_polygon.h"

namespace tilemend {

// What a user says that the water in an area is. A lake has one level; a river falls along a line.
enum class WaterKind { kUnsaid, kLake, kRiver };

// What a reviewer decided on the holes that an area covers (--decisions). kWater and kGround: what the area's `water`
// and `level` say.
enum class ReviewDecision { kNone, kAccept, kWater, kGround, kOpen };

inline constexpr double kClearHeight = 1.5;  // metres, of WaterArea::clear_height where none is given

// All in metres relative to the scene's origin, as the tiles' coordinates.
struct WaterArea {
  bool water = true;  // false: what it covers is no water
  PlanePolygon polygon = {};
  std::optional<double> level = std::nullopt;  // height of the water; none: from its shore
  std::vector<Point2> centreline = {};         // of a river, in either direction; empty or at least two points
  std::string label = {};                      // of the feature in the file, for people
  WaterKind kind = WaterKind::kUnsaid;         // kRiver has no level, kLake no centreline, both have water
  // Surface inside is taken out before holes are looked for. Of water that is what stands no higher than clear_height
  // above the level; if `water` is false, everything.
  bool clear = false;
  double clear_height = kClearHeight;
  // Nobody gave `level`: its standard deviation, metres. Measured on the surface inside that is taken out
  // (waves/clearing.h), or the estimate of an earlier run, out of its holes.geojson.
  std::optional<double> level_sigma = std::nullopt;
  bool is_as_found = false;                         // it says what an earlier run found, and nobody changed it
  bool is_mostly_open = false;                      // of its polygon less than half was there as surface
  std::vector<CellId> cleared_cells = {};           // of whose tiles triangles were taken out
  ReviewDecision decision = ReviewDecision::kNone;  // kNone: an area of --water or --clear
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_WATER_AREAS_H_
