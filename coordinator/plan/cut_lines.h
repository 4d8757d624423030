// Where the grid lines run, and how the tiles of neighbouring cells meet there.
#ifndef TILEMEND_COORDINATOR_PLAN_CUT_LINES_H_
#define TILEMEND_COORDINATOR_PLAN_CUT_LINES_H_

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "coordinator/plan/plan.h"

namespace tilemend {

// The sides of a cell. Across kWest lies column - 1, across kSouth row - 1.
enum Side : int { kWest = 0, kEast = 1, kSouth = 2, kNorth = 3 };
inline constexpr std::array<Side, 4> kSides = {kWest, kEast, kSouth, kNorth};

CellId Across(CellId cell, Side side);
inline int AxisOf(Side side) { return side < kSouth ? 0 : 1; }         // the axis that is constant along the side
inline double OutwardOf(Side side) { return side % 2 == 0 ? -1 : 1; }  // sign of the outward direction on that axis

struct CutLines {
  bool independent = false;  // every tile ends at an outline of its own (overlap or gap): tiles share no vertices
  bool clipped = true;       // no triangle crosses a grid line (else ragged); of no meaning when independent
  double tolerance = 1e-3;   // a rim edge whose ends are both within this of its tile's side lies on that side
  std::map<std::pair<CellId, int>, double> coordinate;  // of each side of each cell of the area
  std::set<std::pair<CellId, CellId>> left_open;  // borders at the rim of an area that is not known: no seams there
  std::vector<BorderAudit> borders;

  double At(CellId cell, Side side) const { return coordinate.at({cell, side}); }
};

// Works out the lines from the tiles' boundaries: a line takes the coordinate at which the tiles there end (new
// vertices on it must agree with theirs to the bit), else the grid's own, rounded to `lattice_step`.
CutLines FindCutLines(const PlanInput& input, double lattice_step);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_CUT_LINES_H_
