// Puts patches into a tile.
#ifndef TILEMEND_COMMON_ASSEMBLE_ASSEMBLE_H_
#define TILEMEND_COMMON_ASSEMBLE_ASSEMBLE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/codec/mesh_file.h"
#include "common/codec/mtl.h"
#include "common/records/cell_holes.h"
#include "common/records/fill_colour.h"

namespace tilemend {

// The patches of one cell as an addition to its tile. The `vertices` are those of the CellHoles that the patches were
// made from. The number of vertices in the tile is `tile_vertices` (0 without a tile). Vertices of neighbours and seam
// vertices become new vertices, each once. A new vertex takes its further properties from the nearest vertex of the
// tile along the patch. If `colours` says so, it takes the colour of its hole. The triangles of each hole get the
// material of its colour. Patches with a failure are left out. Precondition: `colours` has all holes of the other
// patches. Linear.
FilePatch MergePatches(std::span<const RimVertex> vertices, std::span<const HolePatch> patches, CellId cell,
                       int32_t tile_vertices, const FillColours& colours);

// The materials of the patches that have no failure, each once, in the order of their holes.
std::vector<FillMaterial> MaterialsOf(std::span<const HolePatch> patches, const FillColours& colours);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_ASSEMBLE_ASSEMBLE_H_
