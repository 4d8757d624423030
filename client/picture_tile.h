// A tile with what it looks like, for pictures of it.
#ifndef TILEMEND_CLIENT_PICTURE_TILE_H_
#define TILEMEND_CLIENT_PICTURE_TILE_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/util/colour.h"
#include "common/util/tile_files.h"
#include "worker/check/tile_change.h"

namespace tilemend {

struct PictureTile {
  using Corners = std::array<std::array<float, 2>, 3>;
  struct Material {
    std::string image;    // path from the scene's folder; empty: only a colour
    int32_t number = -1;  // of the image in that file, if it is a file of a tree
    Rgb colour{};
  };

  LookedMesh faces;                  // without looks: what was filled is told by its place
  std::vector<Corners> coordinates;  // of each triangle, v upward; empty: no triangle has any
  std::vector<int32_t> material_of;  // of each triangle, into `materials`; -1: none
  std::vector<Material> materials;
  std::vector<Rgb> vertex_colours;  // of the mesh's vertices; empty: none
};

// Reads the tile `path` of the scene or output `root`. Errors of ParseMesh; material files that cannot be read leave
// their triangles without a material. Linear in the file.
absl::StatusOr<PictureTile> ReadPictureTile(const std::string& root, const std::string& path,
                                            const TileFrame& frame = {});

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_PICTURE_TILE_H_
