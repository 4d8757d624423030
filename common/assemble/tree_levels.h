// Changes all levels of detail of a tile alike that is a tree of files.
#ifndef TILEMEND_COMMON_ASSEMBLE_TREE_LEVELS_H_
#define TILEMEND_COMMON_ASSEMBLE_TREE_LEVELS_H_

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/assemble/clear_tile.h"
#include "common/assemble/tree_paint.h"
#include "common/codec/mesh_file.h"
#include "common/codec/mtl.h"
#include "common/mesh/clear_area.h"
#include "common/mesh/tri_mesh.h"
#include "common/records/level_counts.h"

namespace tilemend {

// ClearTile of a pack of files: every level loses the triangles that AreasThatClear names in it. `file` and the
// counts of `triangles` are of the finest level, those of `levels` of all. `surfaces` are not welded.
absl::StatusOr<ClearedTile> ClearTreeLevels(std::string_view pack, std::span<const ClearArea> areas,
                                            const std::string& name);

struct PatchedTree {
  std::string pack;
  std::vector<LevelCounts> levels;         // `filled` and `added` of each level, the coarsest first
  std::vector<std::string> warnings = {};  // on holes of coarser levels that stay open
  // By TileTree::pieces: how many geometries are new, those with the highest `order` of the piece's part.
  std::vector<int32_t> new_geometries = {};
};

// The pack with `patch`, an addition to its finest level, and with what FillLevel makes of it on each coarser one.
// `cleared` are the `surfaces` of ClearTreeLevels if the pack is what that left. A triangle goes to the piece
// (tile_tree.h) in whose bounds its middle lies seen from above, or that is nearest; of several the nearest in height,
// then the lowest. `materials` are the colours of the patch's materials. Errors of ReadTileTree and ChangeTileTree.
// Linear in the tile, and as FillLevel for each level. With `paint` the new faces of a part get the image that it
// gives, named `image_name`; its errors are handed on.
absl::StatusOr<PatchedTree> PatchTreeLevels(std::string_view pack, const FilePatch& patch,
                                            std::span<const FillMaterial> materials, const std::string& name,
                                            const PaintFaces& paint = {}, const std::string& image_name = "",
                                            std::span<const TriMesh> cleared = {});

}  // namespace tilemend

#endif  // TILEMEND_COMMON_ASSEMBLE_TREE_LEVELS_H_
