// Finds the holes of each cell: the regions that rim edges and seams bound, and what kind they are.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_REGIONS_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_REGIONS_H_

#include <set>
#include <string>
#include <vector>

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// A boundary segment of a hole with what classification needs to know of it.
struct BoundarySegment {
  RimSegment segment;  // vertices: rim points, then seam vertices
  int32_t side = -1;   // the cell's side it lies along: seams and neighbours' edges; -1: the cell's own edges
  CellId across;       // the cell beyond, when side >= 0
};

// The boundary of one cell's holes.
struct CellBoundary {
  CellId cell;
  bool has_surface = true;
  std::vector<BoundarySegment> open;                  // of holes that reach the cell's grid boundary
  std::vector<std::vector<RimSegment>> closed_loops;  // loops inside the cell, hole on the left
  std::string seam_failure;                           // why a seam of the cell could not be laid; empty if all were
};

struct RegionResult {
  std::vector<PlannedHole> holes;
  std::vector<LeftOpen> left;
  int64_t outer_rims = 0;
};

// Classifies by Wang 2021, 3.1 (types A to D, I and II) and Zhang 2022, 4.1 (single holes); definitions as in the user
// guide. `position` gives vertices seen from above and `normals` the rim points' normals.
RegionResult FindHoles(const CellBoundary& boundary, const std::set<CellId>& area, const CutLines& lines,
                       const Rim& rim, const std::vector<Point3>& position);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_REGIONS_H_
