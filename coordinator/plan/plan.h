// The plan of a job: which holes there are, where cells meet inside them, and in which order they are filled.
//
// Pure functions of the survey records (Wang 2021, 3.1 and 3.2). Everything here is seen from above, on the grid.
//
// How a hole that lies over several cells is divided. Every unmatched boundary edge (rim edge) is given to the one cell
// that closes on it (closing cell). This is the cell of its tile. If a tile ends at a grid line and the hole lies
// beyond, it is the cell across that line. Where that cell changes along a loop there is a junction. Between two
// junctions the grid line runs through the hole, and a seam is laid there. It is a chain of new vertices on the line
// that ends at the two junctions. Rim edges and seams around a cell bound the holes of the cell. Constrained Delaunay
// triangulation on exact integers finds which regions they bound.
#ifndef TILEMEND_COORDINATOR_PLAN_PLAN_H_
#define TILEMEND_COORDINATOR_PLAN_PLAN_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Plans the filling. Cost O(n log n) in the boundary edges of the scene and the vertices of its seams, which are
// bounded (seam_layout.h); deterministic.
Plan MakePlan(const PlanInput& input, const PlanOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_PLAN_H_
