// The area that a user draws, and the cells of it.
#ifndef TILEMEND_COMMON_GRID_SCENE_AREA_H_
#define TILEMEND_COMMON_GRID_SCENE_AREA_H_

#include "absl/status/status.h"
#include "common/grid/scene.h"

namespace tilemend {

// Makes `area`, which is not empty, the area of the scene. Its rim is known then, and squares of the grid that it
// covers become cells without surface. Squares that it covers by less than 1 % stay outside, with a warning: tiles that
// are larger than their cells reach as far. Where it goes beyond the grid to the west or south, the numbering is
// shifted, with a warning, so that no index is negative. There is also a warning if the area covers less than 1 % of
// the scene's cells. Another one says if a quarter or more of it lies in added cells. An area that covers all cells
// whole is just these cells: Scene::area is empty then.
//
// kInvalidArgument if it covers none of the scene's cells, or its rings times their vertices are more than 1e9. The
// same if it adds more than 10,000 cells plus 20 for each cell of the scene, or spans more than 1,000,000 squares. Cost
// as SharesOf (area_shares.h).
absl::Status CoverArea(PlanePolygon area, Scene& scene);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_SCENE_AREA_H_
