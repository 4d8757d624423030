// The figures of a hole that its boundary alone tells.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_MEASURE_HOLE_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_MEASURE_HOLE_H_

#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// A hole with cell, segments, centre (mean of the vertices), perimeter and number of original boundary vertices.
// Precondition: there are segments.
PlannedHole MeasureHole(CellId cell, std::vector<RimSegment> segments, const std::vector<Point3>& position);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_MEASURE_HOLE_H_
