// Where grid lines enter and leave holes.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_JUNCTIONS_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_JUNCTIONS_H_

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/seam/grid_borders.h"
#include "coordinator/plan/seam/seam_site.h"

namespace tilemend {

// A rim point at which the rim passes from one cell to the next.
struct Junction {
  double t;       // metres along the line
  int32_t point;  // of the rim
  bool start;     // the hole lies towards larger t
};

struct Junctions {
  std::map<Border, std::vector<Junction>> along;  // of borders of the area that have any; in order along each
  std::vector<LeftOpen> failures;                 // where the rim passes between cells that are no neighbours
};

// Finds where the closing cell changes along the loops. A change across
// a corner is two junctions at one point. Junctions nearer than the tolerance of the lines have no order of their own:
// there, starts and ends take turns. Cost O(n log n).
Junctions FindJunctions(const SeamSite& site, const ClosingCells& closing);

// Which grid corners lie in a hole, by the outermost junctions of the four borders there. If they do not agree, or
// there are none, the winding number of the rim decides. A corner that the outline of a ragged surface passes by lies
// in no hole.
std::set<Corner> FindCornersInHoles(const SeamSite& site, const ClosingCells& closing, const Junctions& junctions);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_JUNCTIONS_H_
