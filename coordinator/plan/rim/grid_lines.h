// Where the grid lines run.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_GRID_LINES_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_GRID_LINES_H_

#include <array>
#include <map>
#include <set>
#include <utility>

#include "coordinator/plan/rim/border_audit.h"
#include "coordinator/plan/rim/piece_layout.h"
#include "coordinator/plan/types/cell_side.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct GridLines {
  bool clipped = true;  // as BorderFindings
  bool joined = false;  // independent tiles, cut at the lines for the plan (overlap/joint_tiles.h)
  // A rim edge whose ends both lie within this inside its tile's side, or kOnLine beyond, lies on that side. It is 0 if
  // nearly all of the tiles' boundary lies on the lines to the bit. Then what lies just inside is surface, or a sliver
  // without surface, in its own right.
  double tolerance = kOnLine;
  PieceLayout pieces;                                  // independent: of one tile
  std::map<CellId, std::array<double, 4>> coordinate;  // of each cell of the area, by side
  std::map<CellId, std::array<double, 4>> outline;     // joined: where each cell's tile itself ends
  std::set<std::pair<CellId, CellId>> left_open;  // borders at the rim of an area that is not known: no seams there
  std::set<std::pair<CellId, int>> zigzag;        // ragged: sides at the rim of the area that tiles end at in a zigzag

  double At(CellId cell, Side side) const { return coordinate.at(cell)[side]; }

  // Distance of a point to the inner side of a line of `cell`, metres; negative beyond it.
  double Inside(const Point3& p, CellId cell, Side side) const {
    return (At(cell, side) - p[AxisOf(side)]) * OutwardOf(side);
  }
};

// Works out the lines from the tiles' boundaries. A line takes the coordinate along which most of the tiles' boundary
// runs, over its whole length. New vertices on it must agree with theirs to the bit. A tile of which only the inner
// part is left does not end at the line. Without such a coordinate it takes the grid's own, rounded to `lattice_step`.
// Of independent tiles each side has the coordinate of the tile's own outline. Without a grid nothing lies on the
// lines. At the rim of the area a ragged cut ends in a zigzag if a tile has more boundary vertices beyond the line than
// on it. Cost linear in the tiles' boundary edges.
GridLines FindGridLines(const PlanInput& input, const BorderFindings& borders, double lattice_step);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_GRID_LINES_H_
