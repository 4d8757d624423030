// Which holes are reaches of a river, and its level along them.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_RIVER_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_RIVER_H_

#include <cstdint>
#include <span>
#include <vector>

#include "coordinator/plan/water/area_cover.h"
#include "coordinator/plan/water/river_profile.h"

namespace tilemend {

// What may be a reach: a hole, or the holes of a cluster.
struct Reach {
  std::vector<PlaneSegment> boundary;   // rim and seams; segments inside a cluster occur twice
  std::vector<Point3> shore;            // original rim points that stand on no object
  std::vector<double> bank;             // for each of them: mean height one edge landward; NaN if there is none
  double noise = 0;                     // metres: standard deviation of the heights
  bool forced = false;                  // known to be water: only its shape and its fall are looked at
  std::vector<Point2> centreline = {};  // given: known to be a river; else found
};

struct River {
  std::vector<size_t> reaches;  // ascending
  RiverProfile profile;         // over all of them, and under the bridges between
  double width = 0;             // metres, mean
  bool falls = true;            // more than noise explains; else one reach that may as well be level
  bool given = false;           // along a centreline that was given
};

// Finds rivers. Reaches whose centrelines end opposite each other, at most 40 m apart ahead and in line, are one:
// something crosses the water between them. The bends into corners there are taken off. It is a river if
//   - it is at least `least_width` metres wide in the mean and three times as long as wide;
//   - it falls no more than 0.5 %, or 2 % if it does so evenly: at least eight stations lie on a line;
//   - in at least seven of eight stations (25 m) the level is the profile's, and the shores' heights gather about the
//     profile as closely;
//   - at least a third of the stations with heights on both shores has the same level on both, within the tolerance and
//     what noise explains, and at least half of those without a quay of more than 0.5 m along one;
//   - the ground one edge landward is not below the profile, in seven of eight stations and in the median, and on the
//     whole it rises from the shore, more than noise explains.
// A reach with a given centreline, alone, is a river if some of its shore is known. One that is forced, alone, has to
// be long and to fall more than the tolerance and three standard errors of a station; the rest is not asked. A reach is
// in one river at most. A lake that is long is a river to this test.
//
// Cost: FindCentrelines' for each reach that is long enough. Deterministic.
std::vector<River> FindRivers(std::span<const Reach> reaches, double tolerance, double least_width);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_RIVER_H_
