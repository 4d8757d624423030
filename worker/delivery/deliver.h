// Writes a tile in any of the formats that tiles are delivered in.
#ifndef TILEMEND_WORKER_DELIVERY_DELIVER_H_
#define TILEMEND_WORKER_DELIVERY_DELIVER_H_

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/tri_mesh.h"
#include "worker/delivery/delivery_tile.h"
#include "worker/delivery/ply_delivery.h"
#include "worker/delivery/tileset_delivery.h"

namespace tilemend {

struct DeliveryTarget {
  std::string format;      // "3dtiles", "osgb", "obj" or "ply"
  std::string stem;        // of the names of its files
  Point3 origin{0, 0, 0};  // of 3dtiles: as of TilesetFilesOf
  PlyColumns ply = {};
};

// A tile that is a tree (its pack) or an OBJ file, for this format. `new_geometries`: as of DeliveryOfTree. Errors of
// ReadTileTree and DeliveryOfObj.
absl::StatusOr<DeliveryTile> DeliveryOf(std::string_view bytes, const ObjBeside& beside, const std::string& format,
                                        std::span<const int32_t> new_geometries = {});

// The origin of the models of the tile at `path`, whose cell has this middle. Vertices of trees are float32 values and
// stay as they are.
Point3 DeliveryOrigin(std::string_view path, const Point2& middle);

// The files, the tile's own first. What the format does not hold is taken out of `tile`, with warnings in it.
// kInvalidArgument for other formats; errors of the writers. Cost: theirs.
absl::StatusOr<std::vector<DeliveryFile>> Deliver(DeliveryTile& tile, const DeliveryTarget& target);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_DELIVERY_DELIVER_H_
