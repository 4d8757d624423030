// The area that a user draws, and the cells of it.
#ifndef TILEMEND_COMMON_GRID_SCENE_AREA_H_
#define TILEMEND_COMMON_GRID_SCENE_AREA_H_

#include "absl/status/status.h"
#include "common/grid/scene.h"

namespace tilemend {

// Makes `area`, which is not empty, the area of the scene: its rim is known then, and squares of the grid that it
// covers become cells without surface. Squares that it covers by less than 1 % stay outside, since tiles that are
// larger than their cells reach as far; a warning says so. Where it goes beyond the grid to the west or south, the
// numbering is shifted, with a warning, so that no index is negative.
// An area that covers less than 1 % of the scene's cells is a warning as well, and one of which a quarter or more lies
// in cells that it adds. An area that covers all cells whole is just these cells: Scene::area is empty then.
//
// kInvalidArgument if it covers none of the scene's cells, adds more than 10,000 and 20 for each of them, or spans more
// than 1,000,000 squares, and if its rings times their vertices are more than 1e9. Cost as SharesOf (area_shares.h).
absl::Status CoverArea(PlanePolygon area, Scene& scene);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_SCENE_AREA_H_
