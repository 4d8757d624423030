// Mesh files: PLY, OBJ and OFF, read at full precision and written back with every original byte that matters.
//
// Guarantees
//  - Positions are read at the file's own precision (float32, float64 or decimal text, correctly rounded to double).
//  - AppendPatch keeps every original vertex, face, property, material, texture coordinate and comment: binary PLY
//    records and OBJ/ASCII lines are copied byte for byte, the patch is appended.
//  - A reader never crashes, hangs or takes memory out of proportion to the file on malformed input; it returns
//    kInvalidArgument with path, place (line or byte offset) and what was expected.
#ifndef TILEMEND_COMMON_CODEC_MESH_FILE_H_
#define TILEMEND_COMMON_CODEC_MESH_FILE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/mesh/rounding.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"
#include "common/util/tile_files.h"

namespace tilemend {

// kTileTree: OSGB files or a tileset with its models, in one pack (common/util/file_pack.h); the mesh is the finest
// level.
enum class MeshFormat { kPly, kObj, kOff, kStl, kTileTree };

struct MeshFile {
  MeshFormat format = MeshFormat::kPly;
  NumberType number_type = NumberType::kFloat64;  // of the positions; text formats are kFloat64
  TriMesh mesh;                                   // polygons are cut (cut_polygon.h)
  int64_t polygon_count = 0;                      // faces with more than three corners
  int64_t file_bytes = 0;
  int64_t bytes_after_end = 0;            // of a PLY: behind its last record, but for white space
  std::vector<int32_t> level_nodes = {};  // of a tree: how many nodes each level has, the coarsest first
};

// New geometry for one file. Index i in a triangle is vertex i of the file when i < MeshFile::mesh.points.size(), and
// new_points[i - MeshFile::mesh.points.size()] otherwise. like[k] is the file's vertex whose further properties
// (colour, normal, ...) new vertex k takes, or -1 for none; `like` has one entry per new point.
struct FilePatch {
  // The triangles from `first` to the next run's have this material, and this colour where faces have colours.
  struct MaterialRun {
    int32_t first = 0;
    std::string material = {};
    std::optional<Rgb> colour = {};
  };

  std::vector<Point3> new_points;
  std::vector<int32_t> like;
  std::vector<Triangle> triangles;
  std::vector<Rgb> colours = {};            // of the new points, in place of those of `like`; empty: none are given
  std::vector<MaterialRun> materials = {};  // of the triangles, in order
  std::string library = {};  // a further material file that an OBJ has to name; empty: its own define the materials
  // Places in an image, u to the right, v upward, and the place of each corner of each triangle; empty: there is none.
  std::vector<std::array<float, 2>> texture_places = {};
  std::vector<Triangle> texture_corners = {};
  // Of each triangle, the one of MeshFile::mesh that it was cut from: in a PLY its face takes the properties of that
  // one's face, except for tilemend_filled. Empty: all are new surface.
  std::vector<int32_t> cut_from = {};
};

// The format by the extension (.ply, .obj, .off, .stl, .osgb, .json, any case). kInvalidArgument naming the format and
// the accepted ones for anything else (.glb, .b3dm, .gltf, .las ... are refused by name).
absl::StatusOr<MeshFormat> MeshFormatOf(std::string_view path);

// Reads a mesh. kNotFound when there is no such file, kPermissionDenied, kInvalidArgument for bad content (also: an
// index out of range, NaN or infinite coordinates, |coordinate| > 1e9 m, a size in the header that the file cannot
// hold, no vertices at all). Time and memory linear in the file.
absl::StatusOr<MeshFile> ReadMeshFile(const std::string& path, const TileFrame& frame = {});

// What becomes of an OBJ file without faces. All of a tile's faces may have been taken out (drop_faces.h).
enum class NoFaces { kRefuse, kAccept };

// Parses `bytes` as `format`; `name` stands in messages. What ReadMeshFile does after reading the bytes.
absl::StatusOr<MeshFile> ParseMesh(MeshFormat format, std::string_view bytes, const std::string& name,
                                   NoFaces no_faces = NoFaces::kRefuse);

// The bytes of the file `original_bytes` with `patch` appended.
//   PLY: same encoding and properties; faces get a last property `uchar tilemend_filled` (0 original, 1 filled). The
//        patch's colours go into the properties red, green, blue of type uchar of vertices and faces, where there are
//        all three. An alpha of type uchar of what is like nothing in the file is 255.
//   OBJ: every original line kept byte for byte; then `v` lines with 17 digits where needed (shortest that round-trip),
//        `vt` lines, `mtllib` with the patch's library, `g tilemend_filled`, `f` lines with `usemtl` where the material
//        changes.
//   OFF: counts in the header updated, vertices inserted after the originals, faces appended.
//   STL: facets appended, the count in a binary header updated.
//   Tree: kInvalidArgument; its levels of detail are filled together (common/assemble/tree_levels.h).
// New coordinates are rounded to the file's number type (common/mesh/rounding.h).
absl::StatusOr<std::string> AppendPatch(MeshFormat format, std::string_view original_bytes, const FilePatch& patch,
                                        const std::string& name);

enum class FaceMark { kFilled, kNone };  // kNone: faces have no property tilemend_filled

// A whole file, as for a cell that had none: binary little-endian PLY of `number_type`, with the patch's colours on its
// vertices.
std::string NewPlyFile(const FilePatch& patch, NumberType number_type, FaceMark mark = FaceMark::kFilled);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_MESH_FILE_H_
