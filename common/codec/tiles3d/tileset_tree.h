// A tile that is a tileset of 3D Tiles with its models: its levels of detail.
#ifndef TILEMEND_COMMON_CODEC_TILES3D_TILESET_TREE_H_
#define TILEMEND_COMMON_CODEC_TILES3D_TILESET_TREE_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/gltf/gltf_file.h"
#include "common/util/file_pack.h"

namespace tilemend {

struct TilesetModel {
  int32_t file = 0;            // index into TilesetTree::packed
  int32_t level = 0;           // number of tiles above it that have a model
  bool is_finest = true;       // no tile below it has a model in the pack
  int32_t parent = -1;         // index into TilesetTree::models of the nearest above it; -1: none
  double geometric_error = 0;  // metres, of its tile; 0 if it is the finest
  GltfFile gltf;               // its points are in the frame of the scene (tileset_frame.h), metres
};

struct TilesetTree {
  std::vector<PackedFile> packed;         // the tileset's entry first; names are relative to its folder
  std::vector<TilesetModel> models;       // parents before children
  int32_t levels = 0;                     // of the deepest model, plus 1
  std::vector<std::string> missing = {};  // models that are named and not in the pack
};

// Reads a tileset and its models from a pack (common/util/file_pack.h) whose first file is its entry. Models that are
// not in the pack are left out, as viewers do, and told in `missing`; so are files that nothing names. Errors of
// ReadTileset, ReadGltf and UnpackFiles; kInvalidArgument if no model has a vertex. Linear in the bytes.
absl::StatusOr<TilesetTree> ReadTilesetTree(std::string_view pack, const std::string& name);

// What is done to one file of the pack.
struct TilesetEdit {
  std::vector<bool> drop;          // of its triangles; empty: none
  std::vector<GltfPatch> patches;  // points in the frame of the scene; `node` is not looked at
};

// The pack with the models changed; `edits` has one entry a file. Bounding volumes grow to hold the new geometry, in
// all files of the tileset that need it; else these stay. Errors of ReadTilesetTree and ChangeGltf. Linear.
absl::StatusOr<std::string> ChangeTilesetTree(const std::vector<PackedFile>& packed,
                                              const std::vector<TilesetEdit>& edits, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TILES3D_TILESET_TREE_H_
