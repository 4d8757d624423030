// The area that the surface of a scene suggests.
#ifndef TILEMEND_COORDINATOR_REPORT_AREA_PROPOSAL_H_
#define TILEMEND_COORDINATOR_REPORT_AREA_PROPOSAL_H_

#include <map>

#include "common/grid/scene.h"
#include "common/records/stored_record.h"

namespace tilemend {

// A polygon along the outline of the surface, a little inside, that covers holes and closes mouths that are up to half
// a cell wide. Empty if the surface is too small. On a raster of 128 squares to a cell, fewer in scenes of more than
// 2000 cells: the outline is some two squares inside the surface's own. Rings have what is inside on their left.
//
// Precondition: cell_size > 0. Null records are of cells without surface. Cost: linear in the raster and the boundary
// edges. Deterministic.
PlanePolygon ProposeArea(const Scene& scene, const std::map<CellId, StoredRecord>& records);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_AREA_PROPOSAL_H_
