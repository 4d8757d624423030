// A tile without the surface that a user asks to take out.
#ifndef TILEMEND_COMMON_ASSEMBLE_CLEAR_TILE_H_
#define TILEMEND_COMMON_ASSEMBLE_CLEAR_TILE_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "common/mesh/clear_area.h"
#include "common/mesh/tri_mesh.h"
#include "common/records/level_counts.h"

namespace tilemend {

struct ClearedTile {
  std::string bytes;                     // of the file without the faces that are taken out
  MeshFile file;                         // what is left; all vertices stay
  std::vector<int64_t> triangles;        // taken out by each area
  std::vector<LevelCounts> levels = {};  // of a tree: `removed` of each level of detail, the coarsest first
  std::vector<TriMesh> surfaces = {};    // of a tree: what a viewer showed there of each level but the finest
};

// The file `bytes` without the triangles that AreasThatClear names. A face with more than three corners goes if all of
// its triangles go. Pure, so that who writes a tile and who checks it agree. Errors of ParseMesh and DropFaces, with
// `name`. Cost as both, linear in the file.
absl::StatusOr<ClearedTile> ClearTile(MeshFormat format, std::string_view bytes, std::span<const ClearArea> areas,
                                      const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_ASSEMBLE_CLEAR_TILE_H_
