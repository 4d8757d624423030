// The level of a river along its centreline: falling, from both shores.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_RIVER_PROFILE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_RIVER_PROFILE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/water_surface.h"
#include "coordinator/plan/water/level_evidence.h"

namespace tilemend {

// A straight fall along a centreline.
struct FallLine {
  std::vector<Point3> stations;  // evenly on the centreline, in its direction, both ends included; z is 0
  double slope = 0;              // metres of height for each station
  size_t with_level = 0;         // stations that have a level of their own
};

// The line through the levels of stations 25 m apart (Theil 1950, Sen 1968). Each level is the LowerMode of the edges
// nearest to the station, of eight at least. The line is fitted twice, so that the fall within a station does not
// count. The second time its edges are moved to the station along the first line. No stations: fewer than two have a
// level. Precondition: at least two points.
FallLine FitFall(const std::vector<Point2>& line, std::span<const RimChain> rim);

struct RiverProfile {
  WaterSurface water;                // downstream; no stations: too few have a level
  std::vector<RemovedRise> removed;  // rises of the shores that the water does not follow
};

// The profile along a centreline that is known to be a river's, with stations as in FitFall. Stations that lie above
// the line through all by three deviations have banks alone and no level: they lie on a line between the others. The
// others are made to fall in the direction in which the line falls (NotRising). Before the first and after the last the
// water goes on along that line, as far as the rim does. Precondition: at least two points. Cost O(stations^2 + edges *
// stations).
RiverProfile FitRiver(const std::vector<Point2>& line, std::span<const RimChain> rim);

// The values, not rising, that are nearest to `values` in weighted least squares (pool adjacent violators). Weights >
// 0. Cost linear.
std::vector<double> NotRising(std::span<const double> values, std::span<const double> weights);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_RIVER_PROFILE_H_
