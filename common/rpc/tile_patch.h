// What the assembly of a tile adds to it: computed by the worker that writes the tile, and again by who checks it.
#ifndef TILEMEND_COMMON_RPC_TILE_PATCH_H_
#define TILEMEND_COMMON_RPC_TILE_PATCH_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/assemble/tree_paint.h"
#include "common/codec/mesh_file.h"
#include "common/codec/mtl.h"
#include "common/mesh/tri_mesh.h"
#include "common/records/level_counts.h"
#include "common/util/colour.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// What the triangles from `first` to the next run's are filled with.
struct FilledRun {
  int32_t first = 0;
  bool is_water = false;
  Rgb colour;  // of the hole
};

struct TilePatch {
  FilePatch patch;
  std::vector<FilledRun> runs;
  std::vector<FillMaterial> materials;  // of its filled faces; empty: it has none, or its format has no materials
  PaintFaces paint;                     // of a tile that is a tree; empty: faces have the colours of their holes
};

// The patches of the input, moved where seams were smoothed, as an addition to its tile. kInvalidArgument if the input
// does not fit together. Linear.
absl::StatusOr<TilePatch> TilePatchOf(const v1::AssembleInput& input);

// Lays the image AssembleInput.texture on the patch, instead of the colours of holes.
void SetTexture(const v1::AssembleInput& input, std::vector<std::array<float, 2>> places, std::vector<Triangle> corners,
                TilePatch& added);

// Takes the places in the image from a tile that was written with the patch, for PatchedTile to be compared with it; of
// a tree (`original` and `written` are packs), the images too. kInvalidArgument if the tile does not end with as many
// textured triangles. Linear.
absl::Status TakeTexture(const v1::AssembleInput& input, std::string_view original, std::string_view written,
                         TilePatch& added);

struct PatchedBytes {
  std::string bytes;
  std::vector<LevelCounts> levels = {};      // of a tree, without `nodes`; empty for other formats
  std::vector<std::string> warnings = {};    // on holes of coarser levels that stay open
  std::vector<int32_t> new_geometries = {};  // of a tree with a patch: as of PatchedTree
};

// The bytes of the tile with the patch, in all of its levels of detail: of a new file if the cell has no tile, else of
// `original`, which has the format that its path says, without what is taken out of it (ClearTile). Errors as ClearTile
// and AppendPatch.
absl::StatusOr<PatchedBytes> PatchedTile(const v1::AssembleInput& input, const TilePatch& added,
                                         std::string_view original);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_TILE_PATCH_H_
