// The area that the surface of a scene suggests.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_AREA_PROPOSAL_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_AREA_PROPOSAL_H_

#include <map>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// A polygon along the outline of the surface, a little inside, that covers holes and closes mouths that are up to half
// a cell wide. Empty if the surface is too small. Works on a raster of 128 squares to a cell, fewer in scenes of more
// than 2000 cells. So the outline is some two squares inside the surface's own. Rings have what is inside on their
// left.
//
// Precondition: cell_size > 0. Null records are of cells without surface; no cell has a negative index. Cost: linear in
// the raster and the boundary edges. Deterministic.
PlanePolygon ProposeArea(const Grid& grid, const std::map<CellId, StoredRecord>& records);

// The same where the surface ends far inside the cells. It then leaves out more than twice as much of them as where
// each tile fills its cell. Else empty.
PlanePolygon OutlineInsideCells(const Grid& grid, const std::map<CellId, StoredRecord>& records);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_AREA_PROPOSAL_H_
