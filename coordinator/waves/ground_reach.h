// Which tiles tell ground from objects at the boundary of a tile.
#ifndef TILEMEND_COORDINATOR_WAVES_GROUND_REACH_H_
#define TILEMEND_COORDINATOR_WAVES_GROUND_REACH_H_

#include <map>
#include <vector>

#include "common/grid/scene.h"
#include "common/records/stored_record.h"

namespace tilemend {

// Whether ground is told from objects in a scene of such cells. Where they are so small that the ground filter would
// look at more than 20 of them in each direction, all is taken for ground.
bool IsGroundTold(const Grid& grid);

// The cells whose tiles come within kGroundReach and five squares of the raster of that of `cell`, itself among them,
// by row and column. Tiles may reach beyond their cells by up to one cell. Precondition: `cell` has a tile.
std::vector<CellId> CellsInGroundReach(const std::map<CellId, StoredRecord>& records, const Grid& grid, CellId cell);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_GROUND_REACH_H_
