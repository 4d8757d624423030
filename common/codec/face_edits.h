// Has faces of a mesh file name other vertices, and leaves every other byte as it is.
#ifndef TILEMEND_COMMON_CODEC_FACE_EDITS_H_
#define TILEMEND_COMMON_CODEC_FACE_EDITS_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"

namespace tilemend {

// The faces that the triangles of a mesh are parts of.
struct FileFaces {
  MeshFile file;
  std::vector<int32_t> face_of;  // of each triangle, rising; polygons have several
  bool has_textures = false;     // corners have texture coordinates: `vt` of an OBJ, `texcoord` of a PLY's faces
};

// What ParseMesh reads, with the faces. Errors of ParseMesh.
absl::StatusOr<FileFaces> ParseFaces(MeshFormat format, std::string_view bytes, const std::string& name);

struct TriangleChange {
  int32_t triangle = 0;  // of MeshFile::mesh
  Triangle from, to;     // vertices of the file; no new ones
};

// `bytes` with the corners of some triangles changed. Numbers of corners that stay are not written anew. STL has no
// numbers of vertices: there a corner takes the coordinates of its new vertex, as they are written there. Normals of
// facets stay. Precondition: ParseMesh takes `bytes`; triangles of one polygon agree. Linear.
absl::StatusOr<std::string> ChangeTriangles(MeshFormat format, std::string_view bytes,
                                            std::span<const TriangleChange> changes, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_FACE_EDITS_H_
