// Edges inside a hole where the neighbour's outline runs through it.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_STRIP_EDGES_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_STRIP_EDGES_H_

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Where two tiles overlap, gives the hole of each the other's outline too (PlannedHole::inner_edges), as far as it is
// clear of the hole's own rim. The new vertices are those of the other's outline, with the heights that they have
// there. Before a corner, where four tiles overlap, the outlines get vertices where they cross. Between the outlines
// both get the same diagonals. Before a rim, where the last vertices of the two are not level, both get an edge between
// these. So in the strip that both fill, both have one surface, up to the last vertices before a rim. Water has so
// anyway, and gets nothing.
//   outlines  those of the tiles
// O(n log n) in the segments of the holes, and for each vertex on an outline those near the outline.
void LayStripEdges(const GridLines& outlines, Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_STRIP_EDGES_H_
