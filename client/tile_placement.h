// Whether the files of an output that say where tiles lie say what those of the scene say.
#ifndef TILEMEND_CLIENT_TILE_PLACEMENT_H_
#define TILEMEND_CLIENT_TILE_PLACEMENT_H_

#include <string>
#include <vector>

#include "common/grid/scene.h"

namespace tilemend {

// Compares the files that the output `out` has to have of this `scene`:
//   metadata.xml is the same file;
//   scene.json has the CRS, the origin, the grid and the tiles of the scene;
//   tilesets differ in bounding volumes alone, and these hold those of the scene;
//   in another format, tileset.json and metadata.xml are those of coordinator/jobs/delivery_entry.h.
// Without `has_area`, the area of the job is not in the scene, and grid and tiles are not compared. Tilesets of tiles
// that the output does not have are left out. Returns a note for each file that is missing or differs, which begins
// with its path. Linear in the files, of which those of one tileset are in memory.
std::vector<std::string> ChangedPlacement(const Scene& scene, const std::string& out, bool has_area);

// What is wrong with the text `after` of a file of a tileset that was `before`; empty: nothing. Precondition: both are
// files of a Tileset (common/codec/tiles3d/tileset.h). Linear.
std::string TilesetChange(const std::string& before, const std::string& after);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_TILE_PLACEMENT_H_
