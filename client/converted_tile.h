// A tile of a scene as an output in another format has it where nothing is filled.
#ifndef TILEMEND_CLIENT_CONVERTED_TILE_H_
#define TILEMEND_CLIENT_CONVERTED_TILE_H_

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "client/checked_tile.h"
#include "common/grid/scene.h"
#include "worker/delivery/deliver.h"

namespace tilemend {

// What positions were before they were rounded, by the bits of the rounded ones. Of two that were rounded to one, the
// lower one counts.
using ExactPositions = std::map<std::array<uint64_t, 3>, std::array<double, 3>>;

struct ConvertedTile {
  CheckedTile tile;
  std::vector<DeliveryFile> beside;  // its material file and images, by their paths in the output
  // Of a format whose tiles have origins of their own: neighbours round one vertex to two positions.
  ExactPositions exact;
};

// Converts a tile of `scene` in memory, as the job did that wrote the output `out`. Precondition: it has a path, and
// SceneTile::delivered is set. Errors of ReadTileBytes, DeliveryOf and Deliver. Linear, and O(n log n) for 3D Tiles.
absl::StatusOr<ConvertedTile> ConvertTile(const Scene& scene, const SceneTile& tile, const std::string& out);

// Gives vertices the positions that they had before they were rounded. O(n log n).
void Restore(const ExactPositions& exact, CheckedTile& tile);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_CONVERTED_TILE_H_
