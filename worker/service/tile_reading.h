// Reads the tiles that tasks name.
#ifndef TILEMEND_WORKER_SERVICE_TILE_READING_H_
#define TILEMEND_WORKER_SERVICE_TILE_READING_H_

#include <string>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// The path of the tile's file.
std::string PathOf(const v1::TileRef& tile);

// The bytes of a file. While they are read the thread's core is lent to others. Errors of ReadFile.
absl::StatusOr<std::string> ReadTile(const v1::TileRef& tile);

// The bytes of a tile as it was surveyed. The `stamp` is the one that the file had then, "" if it is not known. A file
// that still has it is not digested again. Errors of ReadFile; ChangedInJob if the file is another one now.
absl::StatusOr<std::string> ReadSurveyed(const v1::TileRef& tile, const std::string& stamp = "");

// The mesh of a tile with these bytes, without the surface that its polygons take out. Errors of ParseMesh and
// ClearTile.
absl::StatusOr<MeshFile> MeshOf(const v1::TileRef& tile, const std::string& bytes);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_TILE_READING_H_
