// New tileset.json files of 3D Tiles 1.1.
#ifndef TILEMEND_COMMON_CODEC_TILES3D_NEW_TILESET_H_
#define TILEMEND_COMMON_CODEC_TILES3D_NEW_TILESET_H_

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace tilemend {

struct NewTile {
  std::string file;                          // a model or a tileset, relative to the folder of the new file; or empty
  double geometric_error = 0;                // metres
  Eigen::AlignedBox3d box;                   // of all below, in the tile's own frame, z up
  std::optional<Eigen::Matrix4d> transform;  // from the tile's frame to that of its parent
  std::vector<NewTile> children;             // that take its place
};

// The text of a tileset with this root. Errors are raised where a child has more than its parent. Linear.
std::string NewTileset(NewTile root);

// One of the tilesets that an entry names.
struct EntryPart {
  std::string file;           // relative to the entry's folder
  Eigen::Matrix4d transform;  // from its frame to that of the root's parent
};

// The text of an entry that names `parts`, which are read in `folder` for their volumes. The transform `root` leads
// from the frame of the root to that of its parent, the Earth-centred one of WGS 84, or is none. Errors of ReadTileset.
// Linear in the parts' own files.
absl::StatusOr<std::string> NewEntry(const std::string& folder, const std::vector<EntryPart>& parts,
                                     const std::optional<Eigen::Matrix4d>& root);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TILES3D_NEW_TILESET_H_
