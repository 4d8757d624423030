// A tile as the acceptance check sees it, whatever its format.
#ifndef TILEMEND_CLIENT_CHECKED_TILE_H_
#define TILEMEND_CLIENT_CHECKED_TILE_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/records/tile_files.h"
#include "worker/check/tile_change.h"

namespace tilemend {

struct CheckedTile {
  LookedMesh faces;
  TileFiles files;                  // material files and images that it names
  std::vector<LookedMesh> coarser;  // its other levels of detail, the coarsest first
};

// Reads the tile `path` of the scene or output `root`. The one place that knows formats of tiles. Errors of ParseMesh.
// Linear in the file.
absl::StatusOr<CheckedTile> ReadCheckedTile(const std::string& root, const std::string& path,
                                            const TileFrame& frame = {});

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_CHECKED_TILE_H_
