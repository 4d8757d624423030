// How the holes of one part of the scene are divided between its cells.
#ifndef TILEMEND_COORDINATOR_PLAN_DIVISION_H_
#define TILEMEND_COORDINATOR_PLAN_DIVISION_H_

#include <map>
#include <set>
#include <vector>

#include "coordinator/plan/hole/cell_boundary.h"
#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/seam/seam_layout.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Cells whose tiles share vertices. All of it must outlive the part.
struct Part {
  const PlanInput& input;
  const PlanInput& own;  // the tiles as they are: of joined ones `input` has what their cells have in common
  const GridLines& lines;
  const PlanOptions& options;
  const Rim& rim;
  double lattice_step = 0;
};

struct Division {
  SeamLayout seams;
  std::map<CellId, FoundHoles> holes;  // their vertices: rim points, then seam vertices
};

// Divides the holes of a scene whose tiles share vertices. If holes fail, other ways are tried. One is seams that keep
// to their lines. On a ragged cut another is that edges around the failures go back to their owners. The way with the
// fewest failures stays. `closing` is FindClosingCells' before sizes were raised (rim_sizes.h).
Division DivideScene(const Part& part, const ClosingCells& closing);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_DIVISION_H_
