// What kind of hole a boundary bounds.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_TYPES_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_TYPES_H_

#include <span>
#include <vector>

#include "coordinator/plan/hole/cell_boundary.h"
#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Zhang 2022, 4.1, for a closed hole: the outer loop and its islands' outlines. `position` is by vertex. Precondition:
// no loop is empty.
SingleType ClassifySingle(std::span<const RimSegment> outer, const std::vector<std::vector<RimSegment>>& islands,
                          const std::vector<Point3>& position);

// Classifies by Wang 2021, 3.1, from the stretches of the cell's outline that the hole takes up. The rest of the
// outline falls into one arc for each part of the surface.
HoleType ClassifyOpen(std::span<const BoundarySegment> segments, CellId cell, bool has_surface, const GridLines& lines,
                      const std::vector<Point3>& position);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_TYPES_H_
