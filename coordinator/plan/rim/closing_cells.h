// Which cell closes on each rim edge.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_CLOSING_CELLS_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_CLOSING_CELLS_H_

#include <span>
#include <vector>

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"

namespace tilemend {

// By rim edge: the cell that closes on it. A square outside the area: nobody does.
using ClosingCells = std::vector<CellId>;

// Gives each edge to its owner. If the tile ends at a grid line and the hole lies beyond, gives it to the cell across
// that line. On a ragged cut a tile ends along a zigzag about the line. There an edge belongs across if it is within an
// edge's length of the line and faces it. A run of edges too shallow to bound a hole of its own goes to the cell around
// it (shallow_runs.h). Edge's lengths are the points' reaches. Cost O(n log n) in the edges, and for each loop its
// edges times the runs that go to the cell around them.
ClosingCells FindClosingCells(const PlanInput& input, const GridLines& lines, const Rim& rim);

// Gives the edges within `reach` metres of any of the points back to their owners. Edges that face out of the area stay
// as they are.
void GiveBackNear(const PlanInput& input, const Rim& rim, std::span<const Point2> points, double reach,
                  ClosingCells& closing);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_CLOSING_CELLS_H_
