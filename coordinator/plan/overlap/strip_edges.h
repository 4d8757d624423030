// Edges inside a hole where the neighbour's outline runs through it.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_STRIP_EDGES_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_STRIP_EDGES_H_

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Where two tiles overlap, gives the hole of each the other's outline too (PlannedHole::inner_edges), over vertices
// beside those of its own outline as far as they are clear of the rim; where four tiles do, also the points in which
// their outlines cross. All of them follow the same vertices on the grid line, and so have the heights that the
// neighbour has there. Where the neighbour's rim crosses the strip its surface ends, and the hole gets vertices with
// that rim's heights on both outlines. So in the strip that both fill, both have one surface. Water has so anyway, and
// gets nothing.
//   outlines  those of the tiles
// O(n log n) in the segments of the holes, and for each vertex on an outline those near the outline.
void LayStripEdges(const GridLines& outlines, Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_STRIP_EDGES_H_
