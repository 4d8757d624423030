// Finds the holes of a cell: the regions that rim edges and seams bound, and what kind they are.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_REGIONS_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_REGIONS_H_

#include "coordinator/plan/hole/cell_boundary.h"
#include "coordinator/plan/hole/hole_site.h"

namespace tilemend {

// Classifies by Wang 2021, 3.1 (types A to D, I and II) and Zhang 2022, 4.1 (single holes); definitions as in the user
// guide. Open holes (open_holes.h) come first, then closed ones in the order of their loops. The outline of a detached
// piece (closed_loops.h) is an island of the hole that it lies in. If it lies in none, it is left, as an outer rim.
FoundHoles FindHoles(const HoleSite& site, const CellBoundary& boundary);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_REGIONS_H_
