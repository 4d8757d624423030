#include "common/codec/tree_mesh.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/text.h"

namespace tilemend {

absl::StatusOr<MeshFile> FinestMesh(const TileTree& tile, int64_t bytes, const std::string& name, NoFaces no_faces) {
  MeshFile file;
  file.format = MeshFormat::kTileTree;
  file.number_type = NumberType::kFloat32;
  file.file_bytes = bytes;
  file.mesh = std::move(LevelOf(tile, tile.levels - 1).mesh);
  file.level_nodes.resize(static_cast<size_t>(tile.levels));
  for (const TreePiece& piece : tile.pieces) ++file.level_nodes[static_cast<size_t>(piece.level)];
  if (file.mesh.points.empty()) return absl::InvalidArgumentError(absl::StrCat(name, ": ", kNoVertices));
  if (file.mesh.triangles.empty() && no_faces == NoFaces::kRefuse) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": the file has no triangles"));
  }
  return file;
}

}  // namespace tilemend
