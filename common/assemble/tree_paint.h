// Images for the new faces of a tile that is a tree of files.
#ifndef TILEMEND_COMMON_ASSEMBLE_TREE_PAINT_H_
#define TILEMEND_COMMON_ASSEMBLE_TREE_PAINT_H_

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/tree/tile_tree.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"

namespace tilemend {

// New faces of one part of one file.
struct TreeFaces {
  int32_t file = 0, part = 0;  // as of TreePiece
  int32_t above_finest = 0;    // levels that are finer
  std::vector<Point3> points;  // metres, frame of the scene
  std::vector<Triangle> triangles;
  std::vector<Rgb> colours;  // of each triangle: what it has without an image
};

struct FacePaint {
  std::string image;                                         // a JPEG
  std::vector<std::array<std::array<float, 2>, 3>> corners;  // of each triangle: places in the image, v upward
};

using PaintFaces = std::function<absl::StatusOr<FacePaint>(const TreeFaces& faces)>;

// The faces as geometry with its image: a point for each of its places in the image. kInvalidArgument for paint with
// another number of triangles. O(n log n).
absl::StatusOr<TreePatch> PaintedPatch(const TreeFaces& faces, FacePaint paint, const std::string& image_name);

// The paint of a tile that was written, for its faces: with it the tile can be made once more and compared. Both
// `original` and `written` are packs; the result has all that it needs. It is empty if the written tile has no new
// geometry with an image. For faces that are not in the written tile it gives kInvalidArgument. Errors of ReadTileTree.
absl::StatusOr<PaintFaces> PaintOfWritten(std::string_view original, std::string_view written, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_ASSEMBLE_TREE_PAINT_H_
