// What a tile looks like: the materials that it names, and the files that they are in.
#ifndef TILEMEND_WORKER_MATERIALS_TILE_LOOK_H_
#define TILEMEND_WORKER_MATERIALS_TILE_LOOK_H_

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/codec/obj.h"
#include "common/records/tile_files.h"
#include "common/util/colour.h"

namespace tilemend {

struct TileMaterial {
  std::optional<Rgb> diffuse;  // of a material without an image that is there
  std::string image;           // relative to the scene's folder; empty: none that is there
};

struct TileLook {
  TileFiles files;
  std::map<std::string, TileMaterial> materials;  // by name; the first definition counts
  FileWitness witness;                            // of both
};

// Reads the material files that the OBJ tile `path` of the scene `root` names. An image is looked for beside the
// material file that names it, then beside the tile. What is missing or lies elsewhere gives a warning that names it.
// Errors of an object store that cannot say whether a file is there.
absl::StatusOr<TileLook> ReadObjLook(const std::string& root, const std::string& path, const ObjTextures& textures);

// The images that the header of a PLY tile names. Errors as above.
absl::StatusOr<TileLook> ReadPlyLook(const std::string& root, const std::string& path, std::string_view bytes);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_TILE_LOOK_H_
