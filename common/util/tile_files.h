// The files of a tile: one mesh file, or a tree of files with levels of detail.
//
// A tile whose path ends in .osgb is a tree: its file names finer files in the same folder, these still finer ones. All
// .osgb files of that folder are the tile's then. A tile whose path ends in .json is a tileset of 3D Tiles: all .json,
// .b3dm and .glb files in its folder and below are the tile's. No other tile may lie there.
#ifndef TILEMEND_COMMON_UTIL_TILE_FILES_H_
#define TILEMEND_COMMON_UTIL_TILE_FILES_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace tilemend {

// Whether a tile at `path` is a tree of files. Not for scene.json and report.json, which are the program's own.
bool IsTileTree(std::string_view path);

// Whether a tile at `path` is a tileset of 3D Tiles.
bool IsTileset(std::string_view path);

// Whether a file with this name may belong to a tree. No file of another kind does.
bool IsTreeFile(std::string_view path);

// Whether the file `path` lies where the files of the tree `tile` do. Both are relative to one folder, and normalised.
bool IsFileOfTree(std::string_view tile, std::string_view path);

// The names of the files of a tile, relative to its folder: its own first, the others sorted. Of a mesh file: its own
// alone. Hidden files and folders, and links to folders, are left out. kResourceExhausted for more than 10,000 files,
// or folders more than 16 deep; errors of ListFolder.
absl::StatusOr<std::vector<std::string>> FilesOfTile(const std::string& path);

// The path of a file in the folder of the tile at `path`.
std::string FileBesideTile(const std::string& path, const std::string& name);

// The bytes of a mesh file, or the PackFiles of a tree. Errors of ReadFile and FilesOfTile.
absl::StatusOr<std::string> ReadTileBytes(const std::string& path);

// What ReadTileBytes would read, in bytes. Errors of LookAt and FilesOfTile.
absl::StatusOr<int64_t> SizeOfTile(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_TILE_FILES_H_
