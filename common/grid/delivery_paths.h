// Where the tiles of a scene are written in another format than their own.
#ifndef TILEMEND_COMMON_GRID_DELIVERY_PATHS_H_
#define TILEMEND_COMMON_GRID_DELIVERY_PATHS_H_

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "common/grid/scene.h"

namespace tilemend {

// The format of the option --output-format that a path stands for: "osgb", "3dtiles", "obj" or "ply"; "" for others.
std::string_view DeliveryFormatOf(std::string_view path);

// Sets SceneTile::delivered of all tiles, if `format` is another one than theirs ("same" never is). Each tile gets a
// folder of its own. "3dtiles": "Data/Tile_+000_-001/Tile_+000_-001.osgb" becomes
// "Data/Tile_p000_m001/Tile_p000_m001.json", since some servers take "+" in a URI for a blank. "osgb" does the reverse,
// and always in "Data". What the format cannot hold is added to the scene's warnings.
//
// Returns kInvalidArgument (FORMAT_NOT_SUPPORTED), with what can be done: PLY tiles are not converted; to osgb no scene
// is whose coordinates float32 holds coarser than the lattice of new vertices. The same error is returned if two tiles
// would be written to one folder. O(n log n).
absl::Status SetDeliveryPaths(std::string_view format, Scene& scene);

// Whether SetDeliveryPaths set any path.
bool IsDelivered(const Scene& scene);

// The frame of what is written of a tile. A delivered tileset has that of the scene, and does not say so itself:
// coordinates far from the origin would be taken for Earth-centred ones.
TileFrame OutputFrame(const SceneTile& tile);

// The scene that the delivered tiles in the folder `root` are.
absl::StatusOr<Scene> DeliveredScene(Scene scene, const std::string& root);

// The scene as the output `root` in its own format has it: cells without surface may have a tile now.
absl::StatusOr<Scene> FilledScene(Scene scene, const std::string& root);

// metadata.xml text with the CRS and the origin of `scene`, as photogrammetry programs write it.
std::string MetadataXml(const Scene& scene);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_DELIVERY_PATHS_H_
