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
// "Data/Tile_p000_m001/Tile_p000_m001.json", since some servers take "+" in a URI for a blank.
//
// Returns kInvalidArgument (FORMAT_NOT_SUPPORTED), with what can be done, if the tiles cannot be written in that format
// without loss. From OSGB, 3dtiles and obj are made; from OBJ, 3dtiles; from 3dtiles, obj. No tiles are converted to
// osgb or ply. The same error is returned if two tiles would be written to one folder. O(n log n).
absl::Status SetDeliveryPaths(std::string_view format, Scene& scene);

// Whether SetDeliveryPaths set any path.
bool IsDelivered(const Scene& scene);

// The scene that the delivered tiles in the folder `root` are.
Scene DeliveredScene(Scene scene, const std::string& root);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_DELIVERY_PATHS_H_
