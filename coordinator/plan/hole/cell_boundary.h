// The boundary of one cell's holes, and what is found in it.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_CELL_BOUNDARY_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_CELL_BOUNDARY_H_

#include <cstdint>
#include <string>
#include <vector>

#include "common/records/stored_record.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// A boundary segment of a hole with what classification needs to know of it.
struct BoundarySegment {
  RimSegment segment;      // vertices: rim points, then seam vertices
  int32_t side = -1;       // the cell's side it lies along: seams and neighbours' edges; -1: the cell's own edges
  CellId across;           // the cell beyond, when side >= 0
  bool area_edge = false;  // it lies along the edge of an area polygon, on the way out at `side`
};

struct CellBoundary {
  CellId cell;
  bool has_surface = true;
  const StoredRecord* surface = nullptr;              // the record of the cell's tile; null: it tells no pieces
  std::vector<BoundarySegment> open;                  // of holes that reach the cell's grid boundary
  std::vector<std::vector<RimSegment>> closed_loops;  // loops inside the cell, hole on the left
  std::string seam_failure;                           // why a seam of the cell could not be laid; empty if all were
};

struct FoundHoles {
  std::vector<PlannedHole> holes;
  std::vector<LeftOpen> left;
  int64_t outer_rims = 0;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_CELL_BOUNDARY_H_
