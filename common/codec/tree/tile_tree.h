// A tile that is a tree of files with levels of detail, whatever their format: OSGB or 3D Tiles.
#ifndef TILEMEND_COMMON_CODEC_TREE_TILE_TREE_H_
#define TILEMEND_COMMON_CODEC_TREE_TILE_TREE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"
#include "common/util/file_pack.h"

namespace tilemend {

// A run of triangles with one image. Its vertices and triangles are contiguous in TreeFile.
struct TreeGeometry {
  int32_t first_vertex = 0;
  int32_t vertex_count = 0;
  int32_t first_triangle = 0;
  int32_t triangle_count = 0;
  int32_t texture = -1;     // index into TreeFile::images; -1: none
  Rgb colour;               // without a texture
  int32_t part = 0;         // of the file
  bool has_colour = false;  // the file says `colour`; else it is white, as viewers draw what has no material
  int64_t order = 0;        // among those of the part: new geometry has the highest
};

struct TreeImage {
  std::string name;         // as the file names it; not a path to open
  size_t offset = 0;        // of the image's bytes in the file
  size_t size = 0;          // 0: they are not in the file
  bool is_encoded = false;  // a JPEG or another format lies in the file
};

struct TreeFile {
  std::vector<Point3> points;            // metres, frame of the scene
  std::vector<std::array<float, 2>> uv;  // one per point, v up; (0, 0) without texture
  std::vector<Triangle> triangles;       // indices into points
  std::vector<TreeGeometry> geometries;
  std::vector<TreeImage> images;
};

// A part of one file: the unit that viewers replace by finer files.
struct TreePiece {
  int32_t file = 0;  // index into TileTree::packed
  int32_t part = 0;  // of that file: a geode of an OSGB file; a glb or b3dm file is one part
  int32_t level = 0;
  bool is_finest = true;       // no finer file takes its place
  int32_t parent = -1;         // index into TileTree::pieces, before this one: whose place it takes; -1: none
  double geometric_error = 0;  // metres, as 3D Tiles have it; 0: it is the finest
};

struct TileTree {
  std::vector<PackedFile> packed;         // the tile's own file first
  std::vector<TreeFile> files;            // as many; empty for those without geometry, and for those that nothing names
  std::vector<TreePiece> pieces;          // those of a file after those of the file that names it
  int32_t levels = 0;                     // of the deepest piece, plus 1
  std::vector<std::string> missing = {};  // files that are named and not there
};

// Reads a tile from its pack (common/util/file_pack.h), whose first file tells the format: a tileset if its name ends
// in .json. Errors of ReadOsgbTile or ReadTilesetTree. Linear in the bytes.
absl::StatusOr<TileTree> ReadTileTree(std::string_view pack, const std::string& name);

// What a viewer shows at one level: the pieces of that level, and coarser ones that nothing replaces, as one mesh.
struct TreeLevel {
  struct Part {
    int32_t piece = 0;
    std::vector<int32_t> geometries;               // of its file
    int32_t first_vertex = 0, first_triangle = 0;  // of `mesh`; up to those of the next part
  };
  TriMesh mesh;  // metres; not welded
  std::vector<Part> parts;
};
TreeLevel LevelOf(const TileTree& tile, int32_t level);

// New geometry of one colour, or with an image.
struct TreePatch {
  std::vector<Point3> points;                 // frame of the scene
  std::vector<Triangle> triangles;            // indices into points
  Rgb colour;                                 // without an image
  int32_t part = 0;                           // of the file
  std::vector<std::array<float, 2>> uv = {};  // one per point, v up; none without an image
  std::string image = {};                     // a JPEG or PNG, as encoded; empty: none
  std::string image_name = {};
};

// What is done to one file of a tile.
struct TreeEdit {
  std::vector<bool> drop;  // of its triangles; empty: none
  std::vector<TreePatch> patches;
};

// The pack with the files changed; `edits` has one entry a file. Of a tileset, bounding volumes grow where the new
// geometry needs it. Errors of ChangeOsgbTile or ChangeTilesetTree.
absl::StatusOr<std::string> ChangeTileTree(const TileTree& tile, const std::vector<TreeEdit>& edits,
                                           const std::string& name);

// The image of a file by its bytes, as encoded; empty if there is none such. `file_name` tells the format.
std::string_view TreeImageIn(std::string_view bytes, int32_t image, const std::string& file_name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_TREE_TILE_TREE_H_
