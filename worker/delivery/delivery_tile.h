// A tile as it is delivered in another format: its levels of detail, with images and colours.
#ifndef TILEMEND_WORKER_DELIVERY_DELIVERY_TILE_H_
#define TILEMEND_WORKER_DELIVERY_DELIVERY_TILE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mtl.h"
#include "common/codec/tree/tile_tree.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"

namespace tilemend {

// Triangles with one image, with one colour, or with colours at their vertices.
struct DeliverySurface {
  TriMesh mesh;                          // metres, frame of the scene
  std::vector<std::array<float, 2>> uv;  // one per point if there is an image, else empty; v up
  int32_t image = -1;                    // into DeliveryTile::images
  Rgb colour;                            // without an image; the mean of `colours`
  std::vector<Rgb> colours = {};         // one per point if vertices have their own, else empty
  bool is_filled = false;                // new surface
};

// What a viewer loads and replaces at once.
struct DeliveryPiece {
  int32_t parent = -1;         // into DeliveryTile::pieces, before this one; -1: none
  double geometric_error = 0;  // metres, as 3D Tiles have it; 0: nothing is finer
  std::vector<DeliverySurface> surfaces;
};

struct DeliveryTile {
  std::vector<DeliveryPiece> pieces;
  std::vector<std::string> images;  // encoded; the first `own_images` are those of the tile, the others of its fills
  // Those of the tile have the same numbers however many of its triangles were cleared.
  size_t own_images = 0;
  std::vector<std::string> warnings;
};

enum class DeliveryLevels { kAll, kFinest };

// The pieces of a tree; with kFinest those that nothing replaces. Images that are no encoded images in their files are
// left out with a warning: their triangles are white. `new_geometries`: as of PatchedTree; empty: none is filled.
// Linear.
DeliveryTile DeliveryOfTree(const TileTree& tile, DeliveryLevels levels, std::span<const int32_t> new_geometries = {});

// What an OBJ tile has beside its own file.
struct ObjBeside {
  std::string root;                      // the scene's folder
  std::string path;                      // of the tile, relative to it
  std::span<const FillMaterial> filled;  // materials of filled faces
  std::string_view filled_image;         // their image; empty: none
};

// One piece of an OBJ tile with these bytes. Material files and images are read from the scene's folder; those that are
// missing give a warning. Where no material is in force, vertices keep their colours. Faces of the group
// tilemend_filled are filled. Faces that name a vertex twice are kept; those with fewer than three corners are not,
// nor are lines and points (`l`, `p`), with a warning that counts them. Errors of ParseTexturedObj. O(n log n).
absl::StatusOr<DeliveryTile> DeliveryOfObj(std::string_view bytes, const ObjBeside& beside);

// Triangles from `first` to the next run's have this colour.
struct ColourRun {
  int32_t first = 0;
  Rgb colour;
};

// One piece of filled surface. Precondition: `runs` begin with triangle 0. Linear.
DeliveryTile DeliveryOfColours(const TriMesh& mesh, std::span<const ColourRun> runs);

// Takes out images of other formats, WebP and KTX2, which glTF without extensions and readers of OSGB do not know:
// their surfaces get one colour, with a warning.
void KeepJpegAndPng(DeliveryTile& tile);

// Takes out the colours of vertices, with a warning: their surfaces get one colour.
void DropVertexColours(DeliveryTile& tile);

// The ending of the name of an image file by its first bytes: "jpg", "png", "webp", "ktx2"; empty: unknown.
std::string_view ImageEnding(std::string_view image);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_DELIVERY_DELIVERY_TILE_H_
