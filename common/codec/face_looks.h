// What the faces of a mesh file have beside positions, as digests.
#ifndef TILEMEND_COMMON_CODEC_FACE_LOOKS_H_
#define TILEMEND_COMMON_CODEC_FACE_LOOKS_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "common/codec/obj.h"
#include "common/codec/tree/tile_tree.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Of each triangle of the file: its material's name, and of its corners the texture coordinates, to the bit, and the
// further columns of the vertices. Linear.
std::vector<uint64_t> ObjFaceLooks(const ObjTextures& textures, std::span<const Triangle> triangles);

// For each triangle of the PLY file, the records of its vertices and of its face, byte by byte. The numbers of vertices
// and the property tilemend_filled, which AppendPatch adds, are left out. Errors of ParsePly. Linear.
absl::StatusOr<std::vector<uint64_t>> PlyFaceLooks(std::string_view bytes, const std::string& name);

// Of each triangle of one level of detail (LevelOf): the texture coordinates of its corners and its image, to the bit,
// and the colour of its material. Colours of vertices are not read. Images are decoded by nobody. Linear.
std::vector<uint64_t> TreeFaceLooks(const TileTree& tile, const TreeLevel& level);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_FACE_LOOKS_H_
