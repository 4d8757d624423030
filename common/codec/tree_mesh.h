// The mesh of a tile that is a tree of files.
#ifndef TILEMEND_COMMON_CODEC_TREE_MESH_H_
#define TILEMEND_COMMON_CODEC_TREE_MESH_H_

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "common/codec/tree/tile_tree.h"

namespace tilemend {

// What ParseMesh gives of a tile with these `bytes` in its pack: the finest level of detail.
absl::StatusOr<MeshFile> FinestMesh(const TileTree& tile, int64_t bytes, const std::string& name, NoFaces no_faces);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TREE_MESH_H_
