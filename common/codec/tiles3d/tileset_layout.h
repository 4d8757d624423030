// Which tilesets a tileset is made of, each of which can be filled on its own.
#ifndef TILEMEND_COMMON_CODEC_TILES3D_TILESET_LAYOUT_H_
#define TILEMEND_COMMON_CODEC_TILES3D_TILESET_LAYOUT_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/util/tile_files.h"

namespace tilemend {

struct TilesetPlace {
  std::string path;  // relative to the folder of the entry
  TileFrame frame;
};

struct TilesetLayout {
  std::string crs;                     // TilesetFrame::crs
  double height = 0;                   // TilesetFrame::height
  std::vector<TilesetPlace> tilesets;  // by their paths; the entry alone, with an empty frame, if it is all one
  std::string warning;                 // why it is all one, though the entry names other tilesets; or empty
};

// Reads the entry of a tileset, but no tileset that it names. They are parts of their own if they lie in folders of
// their own and the entry itself has no model. `turn` as FrameOf takes it. Errors of ReadTileset, with the path. Linear
// in the entry.
absl::StatusOr<TilesetLayout> ReadTilesetLayout(const std::string& folder, const std::string& entry, double turn = 0);

// The text of the entry with bounding volumes that hold the filled tilesets, which are in `written` where they differ
// from those in `folder`. Both are folders that the paths of the entry are relative to. Tilesets that are not in
// `written` are taken as unchanged. Errors of ReadTileset. Linear in the files of the tilesets' entries.
absl::StatusOr<std::string> GrownEntry(const std::string& folder, const std::string& entry, const std::string& written);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TILES3D_TILESET_LAYOUT_H_
