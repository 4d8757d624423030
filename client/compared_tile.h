// A tile of a scene, and the same tile in an output.
#ifndef TILEMEND_CLIENT_COMPARED_TILE_H_
#define TILEMEND_CLIENT_COMPARED_TILE_H_

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "client/checked_tile.h"
#include "common/grid/scene.h"
#include "worker/delivery/tileset_delivery.h"

namespace tilemend {

struct ComparedTile {
  CheckedTile before;                // in the output's format; empty of a cell without a tile
  std::optional<CheckedTile> after;  // none: there is no file, or none that can be read
  std::string damage;                // why it cannot be read, with file and position; empty: it can
  std::vector<DeliveryFile> beside;  // of a tile that was converted: as of ConvertedTile
};

// Reads a tile of `scene` and of the output `out`. An output tile that cannot be read is damage, but where the
// store of objects is at fault. Other errors of ReadCheckedTile and ConvertTile are returned. Linear in the files.
absl::StatusOr<ComparedTile> ReadComparedTile(const Scene& scene, const SceneTile& tile, const std::string& out);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_COMPARED_TILE_H_
