// A tile as the acceptance check sees it, whatever its format.
#ifndef TILEMEND_CLIENT_CHECKED_TILE_H_
#define TILEMEND_CLIENT_CHECKED_TILE_H_

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/records/tile_files.h"
#include "common/util/tile_files.h"
#include "worker/check/tile_change.h"

namespace tilemend {

struct CheckedTile {
  LookedMesh faces;
  TileFiles files;                 // material files and images that it names
  std::vector<std::string> named;  // material files of an OBJ, images of a PLY, as they stand in it
  // The names of files that it or its material files have, and whether there is such a file.
  std::map<std::string, bool> is_there;
  std::set<std::string> undefined;  // materials of its triangles that no material file of an OBJ defines
  // Of each triangle of an OBJ: a texture coordinate is no number, or outside the image. Empty: of none.
  std::vector<bool> off_image;
  std::vector<LookedMesh> coarser;  // its other levels of detail, the coarsest first
};

// Whether `after`, the same tile in an output, names what it named `before`, and then `most_new` files more at most.
bool NamesTheSame(const CheckedTile& before, const CheckedTile& after, size_t most_new);

// The names that `before` does not have, and of which there is no file.
std::vector<std::string> NewMissingNames(const CheckedTile& before, const CheckedTile& after);

// A tile by its bytes (those of ReadTileBytes). Files that it names are not looked at: `files`, `is_there` and
// `undefined` stay empty. The one place that knows formats of tiles. Errors of ParseMesh. Linear.
absl::StatusOr<CheckedTile> ParseCheckedTile(const std::string& bytes, const std::string& name);

// Reads the tile `path` of the scene or output `root`, and looks for the files that it names. Errors of ParseMesh.
// Linear in the file.
absl::StatusOr<CheckedTile> ReadCheckedTile(const std::string& root, const std::string& path,
                                            const TileFrame& frame = {});

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_CHECKED_TILE_H_
