// The sides of a cell, and the cells beyond them.
#ifndef TILEMEND_COORDINATOR_PLAN_TYPES_CELL_SIDE_H_
#define TILEMEND_COORDINATOR_PLAN_TYPES_CELL_SIDE_H_

#include <array>
#include <cstdlib>
#include <utility>

#include "common/grid/scene.h"

namespace tilemend {

// Across kWest lies column - 1, across kSouth row - 1.
enum Side : int { kWest = 0, kEast = 1, kSouth = 2, kNorth = 3 };
inline constexpr std::array<Side, 4> kSides = {kWest, kEast, kSouth, kNorth};

// A vertex this near a grid line was cut there, metres.
inline constexpr double kOnLine = 1e-3;

inline int AxisOf(Side side) { return side < kSouth ? 0 : 1; }         // the axis that is constant along the side
inline double OutwardOf(Side side) { return side % 2 == 0 ? -1 : 1; }  // sign of the outward direction on that axis
// Which way along a side its cell lies on the left: +1 towards larger coordinates.
inline int TurnOf(Side side) { return side == kEast || side == kSouth ? 1 : -1; }
inline Side Opposite(Side side) { return static_cast<Side>(side ^ 1); }

inline CellId Across(CellId cell, Side side) {
  const int32_t step = side % 2 == 0 ? -1 : 1;
  return AxisOf(side) == 0 ? CellId{cell.col + step, cell.row} : CellId{cell.col, cell.row + step};
}

// Where the grid itself has the side, metres on its constant axis.
inline double NominalLine(const Grid& grid, CellId cell, Side side) {
  const int axis = AxisOf(side);
  const int32_t n = (axis == 0 ? cell.col : cell.row) + (side % 2);
  return grid.corner[axis] + n * grid.cell_size[axis];
}

// Whether two cells share a corner and no side.
inline bool AreDiagonal(CellId a, CellId b) { return std::abs(b.col - a.col) == 1 && std::abs(b.row - a.row) == 1; }

// Of the two cells between diagonal ones, that on the right of the way from a to b.
inline CellId RightOfDiagonal(CellId a, CellId b) {
  return (b.col - a.col) * (b.row - a.row) > 0 ? CellId{b.col, a.row} : CellId{a.col, b.row};
}

// A border between two cells; second is east or north of first.
using Border = std::pair<CellId, CellId>;

inline bool IsVertical(const Border& b) { return b.first.row == b.second.row; }
inline int AxisAlong(const Border& b) { return IsVertical(b) ? 1 : 0; }

// The cells on either side of the way along a border to the north or east.
inline CellId LeftOf(const Border& b) { return IsVertical(b) ? b.first : b.second; }
inline CellId RightOf(const Border& b) { return IsVertical(b) ? b.second : b.first; }

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_TYPES_CELL_SIDE_H_
