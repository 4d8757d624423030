// Where the grid lines run, and how the tiles of neighbouring cells meet there.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_GRID_LINES_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_GRID_LINES_H_

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// The sides of a cell. Across kWest lies column - 1, across kSouth row - 1.
enum Side : int { kWest = 0, kEast = 1, kSouth = 2, kNorth = 3 };
inline constexpr std::array<Side, 4> kSides = {kWest, kEast, kSouth, kNorth};

CellId Across(CellId cell, Side side);
inline int AxisOf(Side side) { return side < kSouth ? 0 : 1; }         // the axis that is constant along the side
inline double OutwardOf(Side side) { return side % 2 == 0 ? -1 : 1; }  // sign of the outward direction on that axis

// A vertex this near a grid line was cut there, metres.
inline constexpr double kOnLine = 1e-3;

struct CutLines {
  bool independent = false;  // every tile ends at an outline of its own (overlap or gap): tiles share no vertices
  bool clipped = true;       // no triangle crosses a grid line (else ragged); of no meaning when independent
  // A rim edge whose ends both lie within this inside its tile's side, or kOnLine beyond, lies on that side. 0 where
  // nearly all of the tiles' boundary lies on the lines to the bit: then what lies a hair inside is surface, or a
  // sliver without surface, in its own right.
  double tolerance = kOnLine;
  double piece_reach = 0;  // independent: pieces of one tile overlap, or part, by less than this
  std::map<std::pair<CellId, int>, double> coordinate;  // of each side of each cell of the area
  std::set<std::pair<CellId, CellId>> left_open;  // borders at the rim of an area that is not known: no seams there
  std::vector<BorderAudit> borders;

  double At(CellId cell, Side side) const { return coordinate.at({cell, side}); }
};

// Works out the lines from the tiles' boundaries: a line takes the coordinate along which most of the tiles' boundary
// runs, over its whole length (new vertices on it must agree with theirs to the bit, and a tile of which only the inner
// part is left does not end at the line), else the grid's own, rounded to `lattice_step`.
CutLines FindCutLines(const PlanInput& input, double lattice_step);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_GRID_LINES_H_
