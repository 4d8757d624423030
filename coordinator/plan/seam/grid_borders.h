// Borders between cells and grid corners: what seams run along and between.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_GRID_BORDERS_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_GRID_BORDERS_H_

#include <algorithm>
#include <array>
#include <set>

#include "coordinator/plan/rim/grid_lines.h"

namespace tilemend {

// The grid corner at the south-west of a cell.
using Corner = CellId;

inline Corner LowCorner(const Border& b) { return b.second; }
inline Corner HighCorner(const Border& b) {
  return IsVertical(b) ? Corner{b.second.col, b.second.row + 1} : Corner{b.second.col + 1, b.second.row};
}

// Whether one of its cells is in the area, or both.
inline bool IsOfArea(const Border& b, const std::set<CellId>& area) {
  return area.contains(b.first) || area.contains(b.second);
}

// The cells around a corner, ascending.
inline std::array<CellId, 4> CellsAround(Corner c) {
  return {CellId{c.col - 1, c.row - 1}, CellId{c.col - 1, c.row}, CellId{c.col, c.row - 1}, c};
}

// The borders that meet at a corner.
inline std::array<Border, 4> BordersAt(Corner c) {
  const auto [south_west, north_west, south_east, north_east] = CellsAround(c);
  return {Border{south_west, south_east}, Border{north_west, north_east}, Border{south_west, north_west},
          Border{south_east, north_east}};
}

// Calls `use` for every corner of a cell of the area, once.
template <typename Use>
void ForCorners(const std::set<CellId>& area, const Use& use) {
  for (const CellId cell : area) {
    for (const Corner corner :
         {cell, CellId{cell.col + 1, cell.row}, CellId{cell.col, cell.row + 1}, CellId{cell.col + 1, cell.row + 1}}) {
      const auto around = CellsAround(corner);
      const auto first = std::find_if(around.begin(), around.end(), [&](CellId c) { return area.contains(c); });
      if (*first == cell) use(corner);
    }
  }
}

// The coordinate of the border's line on its constant axis, metres.
double LineOf(const Border& border, const std::set<CellId>& area, const GridLines& lines);

// Where the lines meet at a corner of a cell of the area.
Point2 CornerPosition(Corner corner, const std::set<CellId>& area, const GridLines& lines);

// How far tiles around a corner reach over the line on which `axis` is constant there, at most, metres; 0 unless they
// overlap.
double OverlapAt(Corner corner, int axis, const GridLines& lines);

// Whether a cell around the corner lies outside the area.
bool TouchesOutside(Corner corner, const std::set<CellId>& area);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_GRID_BORDERS_H_
