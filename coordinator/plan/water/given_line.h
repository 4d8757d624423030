// Centrelines that the user gave: through which holes they run, and whether they run one way.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_GIVEN_LINE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_GIVEN_LINE_H_

#include <optional>
#include <span>

#include "coordinator/plan/water/area_cover.h"

namespace tilemend {

// Whether a line of at least two points crosses the outline of a hole (even-odd rule), or lies in it. Cost O(points of
// the line * outline).
bool RunsThrough(std::span<const Point2> line, std::span<const PlaneSegment> outline);

// The first vertex at which a line turns by more than 150 degrees. Of a river no centreline does.
std::optional<Point2> WhereItTurnsBack(std::span<const Point2> line);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_GIVEN_LINE_H_
