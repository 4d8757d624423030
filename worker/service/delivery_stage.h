// Writes tiles in another format than their own.
#ifndef TILEMEND_WORKER_SERVICE_DELIVERY_STAGE_H_
#define TILEMEND_WORKER_SERVICE_DELIVERY_STAGE_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mtl.h"
#include "common/rpc/tile_patch.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/delivery/tileset_delivery.h"

namespace tilemend {

// A tile as it is after the assembly, in its own format.
struct AssembledTile {
  std::string_view bytes;                    // of a tree its pack; not looked at if the cell has no tile
  const TilePatch* patch = nullptr;          // of a cell without a tile: all of its surface
  std::vector<FillMaterial> materials;       // of an OBJ tile's filled faces
  std::string_view image;                    // on these; empty: none
  std::vector<int32_t> new_geometries = {};  // of a tree with a patch: as of PatchedTree
};

struct Delivered {
  std::vector<DeliveryFile> files;  // the first is AssembleInput::output; others by their names beside it
  std::vector<std::string> warnings;
  std::vector<LevelCounts> levels = {};  // of a tree, in its own format
};

// The tile in AssembleInput::output_format. kInvalidArgument for a format that the tile cannot be written in; errors of
// the readers. Linear.
absl::StatusOr<Delivered> DeliverTile(const v1::AssembleInput& input, const AssembledTile& tile);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_DELIVERY_STAGE_H_
