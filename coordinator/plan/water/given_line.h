// Centrelines that the user gave: what lies along them, and whether they run one way.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_GIVEN_LINE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_GIVEN_LINE_H_

#include <optional>
#include <span>
#include <vector>

#include "coordinator/plan/water/river.h"

namespace tilemend {

// Takes a given centreline from reaches that are other water: it does not run through them but through others that have
// it as well, and the level of their shore, of 24 points at least, is off that along the line by more than the
// tolerance and the spread of their heights, or two tolerances. Cost O(points of the line * boundary), and FitRiver's.
void LeaveOtherWater(double tolerance, std::vector<Reach>& reaches);

// The first vertex at which a line turns by more than 150 degrees. Of a river no centreline does.
std::optional<Point2> WhereItTurnsBack(std::span<const Point2> line);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_GIVEN_LINE_H_
