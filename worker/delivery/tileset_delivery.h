// A tile written as a tileset of 3D Tiles with its models.
#ifndef TILEMEND_WORKER_DELIVERY_TILESET_DELIVERY_H_
#define TILEMEND_WORKER_DELIVERY_TILESET_DELIVERY_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/tri_mesh.h"
#include "worker/delivery/delivery_tile.h"

namespace tilemend {

struct DeliveryFile {
  std::string name;  // beside the tile's own file
  std::string bytes;
};

// The files of a tileset "`stem`.json" with a glb for each piece, which takes the place of its parent: the tileset
// first. Its frame is that of the scene. Models are relative to `origin`, so that float32 is fine enough; at zero the
// coordinates keep their bits. Images are written as they are. Errors of NewGlb. Linear.
absl::StatusOr<std::vector<DeliveryFile>> TilesetFilesOf(const DeliveryTile& tile, const std::string& stem,
                                                         const Point3& origin);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_DELIVERY_TILESET_DELIVERY_H_
