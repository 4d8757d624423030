// Borders between cells and grid corners: what seams run along and between.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_GRID_BORDERS_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_GRID_BORDERS_H_

#include <set>
#include <utility>
#include <vector>

#include "coordinator/plan/rim/grid_lines.h"

namespace tilemend {

// The grid corner at the south-west of a cell.
using Corner = CellId;

inline Corner LowCorner(const Border& b) { return b.second; }
inline Corner HighCorner(const Border& b) {
  return IsVertical(b) ? Corner{b.second.col, b.second.row + 1} : Corner{b.second.col + 1, b.second.row};
}

// The borders of all cells of the area, each once, ascending.
std::vector<Border> BordersOf(const std::set<CellId>& area);

// The coordinate of the border's line on its constant axis, metres.
double LineOf(const Border& border, const std::set<CellId>& area, const GridLines& lines);

// Where the lines meet at a corner of a cell of the area.
Point2 CornerPosition(Corner corner, const std::set<CellId>& area, const GridLines& lines);

// Whether a cell around the corner lies outside the area.
bool TouchesOutside(Corner corner, const std::set<CellId>& area);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_GRID_BORDERS_H_
