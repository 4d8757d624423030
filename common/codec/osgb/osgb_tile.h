// A tile that is a tree of OSGB files: its levels of detail.
#ifndef TILEMEND_COMMON_CODEC_OSGB_OSGB_TILE_H_
#define TILEMEND_COMMON_CODEC_OSGB_OSGB_TILE_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/osgb/osgb_file.h"
#include "common/util/file_pack.h"

namespace tilemend {

// A geode of one file: the unit that viewers replace by finer files.
struct OsgbPiece {
  int32_t file = 0;       // index into OsgbTile::packed
  int32_t geode = 0;      // of that file
  int32_t level = 0;      // 0: of the tile's own file; one more in each file that is named there
  bool is_finest = true;  // no finer file takes its place
  int32_t parent = -1;    // index into OsgbTile::pieces, before this one: whose place it takes; -1: of the tile's file
  double geometric_error = 0;  // metres, of 3D Tiles: what a viewer lacks that shows it in place of finer ones
};

struct OsgbTile {
  std::vector<PackedFile> packed;         // the tile's own file first
  std::vector<OsgbFile> files;            // as many; empty where no file that is shown names it
  std::vector<OsgbPiece> pieces;          // level by level, in the order of the files that name them
  int32_t levels = 0;                     // of the deepest piece, plus 1
  std::vector<std::string> missing = {};  // finer files that are named and not in the pack
};

// Reads a tile from its pack (common/util/file_pack.h). Files that it names but that are not in the pack are left
// out, as viewers do, and told in `missing`; so are files that nothing names. Returns kInvalidArgument with file and
// byte offset as ReadOsgb. The same if a file is named twice, or no file has a vertex. Linear in the bytes.
absl::StatusOr<OsgbTile> ReadOsgbTile(std::string_view pack, const std::string& name);

// What is done to one file of a tile.
struct OsgbEdit {
  std::vector<bool> drop;  // of its triangles; empty: none
  std::vector<OsgbPatch> patches;
};

// The pack with the files changed; `edits` has one entry a file. Errors of AppendOsgb and DropOsgbTriangles.
absl::StatusOr<std::string> ChangeOsgbTile(const std::vector<PackedFile>& packed, const std::vector<OsgbEdit>& edits,
                                           const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OSGB_OSGB_TILE_H_
