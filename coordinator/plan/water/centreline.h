// The lines that run along the middle of long holes.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_CENTRELINE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_CENTRELINE_H_

#include <span>
#include <vector>

#include "coordinator/plan/water/area_cover.h"

namespace tilemend {

struct Centreline {
  std::vector<Point2> points;  // from one end to the other; fewer than two: the hole has no length
  double length = 0;           // metres
  double width = 0;            // metres, mean: area over length
};

// The middle of the region that `boundary` bounds (even-odd rule, any order; segments that occur twice bound nothing),
// a point every `station` metres or less. On a raster: the two places farthest apart on the way through the region, and
// between them the middles of what is as far along. Islands do not split it. Parts that are not connected have a line
// each, the largest first; those smaller than an eighth of it have none.
//
// Precondition: station > 0, finite positions. Cost: the raster has at most 1000 squares a side, Dijkstra's way over
// those inside; three times. Deterministic.
std::vector<Centreline> FindCentrelines(std::span<const PlaneSegment> boundary, double station);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_CENTRELINE_H_
