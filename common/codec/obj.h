// Wavefront OBJ: the geometry is read, everything else is kept as text. See mesh_file.h for what is promised.
#ifndef TILEMEND_COMMON_CODEC_OBJ_H_
#define TILEMEND_COMMON_CODEC_OBJ_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "common/codec/polygons.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"

namespace tilemend {

// The group of filled faces.
inline constexpr std::string_view kFilledGroup = "tilemend_filled";

// What lies on the triangles of an OBJ file.
struct ObjTextures {
  // The triangles from `first` to the next run's have this material.
  struct Run {
    int32_t first = 0;
    int32_t material = 0;  // into `materials`
  };

  std::vector<std::string> libraries;  // what follows `mtllib`, each once: one name, or several with blanks between
  std::vector<std::string> materials;  // names after `usemtl`, each once
  std::vector<Run> runs;               // triangles before the first have no material
  std::vector<std::array<float, 2>> coordinates;  // of `vt`; NaN where they are no numbers
  std::vector<Triangle> corners;                  // of each triangle, into `coordinates`; -1: none

  // The triangles from `first` to the next run's are in the group tilemend_filled, or in others.
  struct GroupRun {
    int32_t first = 0;
    bool is_filled = false;
  };
  std::vector<GroupRun> groups = {};                    // triangles before the first are in others
  std::vector<std::optional<Rgb>> vertex_colours = {};  // after the coordinates of `v`; empty: no vertex has one
  // Of each vertex up to the last that has any: a digest of its columns after x y z (a colour or weight); 0 without.
  std::vector<uint64_t> vertex_columns;
  int64_t short_faces = 0;       // with fewer than three corners
  int64_t lines_and_points = 0;  // statements `l` and `p`
};

// What becomes of faces that name a vertex twice and bound no surface (polygons.h). kKeep: they are cut into triangles
// as others are, from their first corner, so that another format can have them.
enum class FlatFaces { kLeaveOut, kKeep };

struct ObjFile {
  MeshFile file;
  ObjTextures textures;
};

// Reads `v` and `f` statements; texture and normal indices are checked for form only, further statements are skipped.
// Positive indices may name vertices that come later in the file; if those of a polygon do, it is read twice. Linear in
// `bytes`.
absl::StatusOr<MeshFile> ParseObj(std::string_view bytes, const std::string& name, const FaceVisitor& visit = {},
                                  NoFaces no_faces = NoFaces::kRefuse);

// The same with materials, texture coordinates, colours and further columns of vertices: 8 bytes for each `vt`, 12 for
// each vertex with such columns, 12 for each triangle more.
absl::StatusOr<ObjFile> ParseTexturedObj(std::string_view bytes, const std::string& name,
                                         NoFaces no_faces = NoFaces::kRefuse,
                                         FlatFaces flat_faces = FlatFaces::kLeaveOut);

// `bytes`, which may have no faces, unchanged, then the patch in group `tilemend_filled`. New vertices take the further
// columns (weight or colour) of the vertex that they are like.
absl::StatusOr<std::string> AppendToObj(std::string_view bytes, const FilePatch& patch, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OBJ_H_
