// Gives every rim edge to the cell that closes on it.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_CLOSING_CELLS_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_CLOSING_CELLS_H_

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"

namespace tilemend {

// Sets RimEdge::label: the owner, or the cell across a grid line when the tile ends at that line and the hole lies
// beyond. On a ragged cut a tile ends along a zigzag about the line; there an edge belongs across if it is within an
// edge's length of the line and faces it, and a run of edges too shallow to bound a hole of its own takes the label
// around it.
void LabelEdges(const PlanInput& input, const CutLines& lines, Rim& rim);

// Gives the edges within `reach` of any of the points back to their owners; edges that face out of the area keep their
// label.
void ResetLabelsNear(const PlanInput& input, const std::vector<Point2>& points, double reach, Rim& rim);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_CLOSING_CELLS_H_
