// The triangles of a tile by the image or the colour that lies on them.
#ifndef TILEMEND_WORKER_MATERIALS_TEXTURED_SURFACE_H_
#define TILEMEND_WORKER_MATERIALS_TEXTURED_SURFACE_H_

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/obj.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"
#include "worker/materials/tile_look.h"

namespace tilemend {

struct TexturedSurface {
  struct Group {
    std::string image;          // relative to the scene's folder, or a name in `encoded`; empty: none
    std::optional<Rgb> colour;  // of a material without an image
    std::vector<int32_t> triangles;
  };

  TriMesh mesh;
  std::vector<Group> groups;  // by image and colour; every triangle is in one

  // Places in the image of a triangle's corners; precondition: it is in a group with an image.
  std::array<std::array<float, 2>, 3> PlacesOf(int32_t triangle) const;

  std::vector<std::array<float, 2>> coordinates;
  std::vector<Triangle> corners;  // empty: no triangle is in a group with an image

  std::map<std::string, std::string> encoded;  // of a tree: its images as they lie in its files, by names for messages
};

// Triangles with an image but without texture coordinates count as those without either. Cost: O(n log n).
TexturedSurface TexturedSurfaceOf(ObjFile obj, const TileLook& look);

// The finest level of a tree, from its pack. Triangles are in a group without an image or a colour if their image does
// not lie in their file as JPEG or PNG. In messages `name` is the tile's. Errors of ReadTileTree. Linear.
absl::StatusOr<TexturedSurface> TexturedSurfaceOfTree(std::string_view pack, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_TEXTURED_SURFACE_H_
