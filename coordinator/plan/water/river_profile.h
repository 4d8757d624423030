// The level of a river along its centreline: falling, from both shores.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_RIVER_PROFILE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_RIVER_PROFILE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/water_surface.h"

namespace tilemend {

struct RiverStation {
  double along = 0;   // metres from the upstream end
  int64_t count = 0;  // shore heights of the station, both sides
  double level = 0;   // metres, as its shores have it; meaningless if count is 0
  int64_t left_count = 0, right_count = 0;
  double left = 0, right = 0;  // metres: the levels of the two shores alone, looking downstream
  bool on_banks = false;       // left out of the profile: no shore is at the water
};

struct RiverProfile {
  WaterSurface water;                  // downstream; no stations: too few shore heights
  std::vector<RiverStation> stations;  // likewise
  double fall = 0;                     // metres from the first station with shore heights to the last one
  bool straight = false;               // the stations' levels lie on one line
  std::vector<RemovedRise> removed;    // rises of more than three standard errors
};

struct StationRule {
  double spacing = 25;     // metres
  int64_t least = 8;       // heights: stations with fewer, or half as many at one shore, have no level of their own
  double tolerance = 0.1;  // metres: by how much the two shores may differ
};

// Stations lie `spacing` metres apart along the line. The level of a station is FitRimLevel's of the shore heights
// beside it, of both shores; where the whole (Theil, Sen) falls by more than noise from one to the next, each moved to
// the station along that slope; where the two shores' own levels differ by more than the tolerance and what noise
// explains, that of the lower one, as banks and quays only rise above the water. Stations with less than `least`
// heights have none of their own, nor have those that lie above a line through all (Theil 1950, Sen 1968) by three
// times the tolerance and three deviations: both shores have banks alone there. The profile is the straight one that
// fits best, weighted by the counts, if seven in eight stations lie on it within the tolerance and three errors, level
// if it falls by less than three standard errors of its slope; else levels are made to fall in the direction in which
// they fall on the whole (NotRising) and lie on a line between stations. Before the first and after the last one they
// stay. Station levels do not depend on objects and banks as long as a third of the heights there is at the water
// (FitRimLevel).
//
//   line    at least two points
//   shore   rim points that stand on no object
//   noise   metres: standard deviation of their heights
RiverProfile FitRiver(const std::vector<Point2>& line, std::span<const Point3> shore, double noise,
                      const StationRule& rule);

// The values, not rising, that are nearest to `values` in weighted least squares (pool adjacent violators). Weights >
// 0. Cost linear.
std::vector<double> NotRising(std::span<const double> values, std::span<const double> weights);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_RIVER_PROFILE_H_
