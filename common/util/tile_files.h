// The files of a tile: one mesh file, or a tree of files with levels of detail.
//
// A tile whose path ends in .osgb is a tree: its file names finer files in the same folder, these still finer ones. All
// .osgb files of that folder are the tile's then. A tile whose path ends in .json is a tileset of 3D Tiles. All .json,
// .b3dm, .glb and image files in its folder and below are the tile's. No other tile may lie there.
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

// Whether tiles of this format, one of those of --output-format, have levels of detail.
bool HasLevelsOfDetail(std::string_view format);

// Whether a file with this name may belong to a tree. No file of another kind does.
bool IsTreeFile(std::string_view path);

// Whether the file `path` lies where the files of the tree `tile` do. Both are relative to one folder, and normalised.
bool IsFileOfTree(std::string_view tile, std::string_view path);

// The names of the files of a tile, relative to its folder: its own first, the others sorted. Of a mesh file: its own
// alone. Hidden files and folders, and links to folders, are left out. Returns kResourceExhausted for more than 10,000
// files, or folders more than 16 deep. Errors of ListFolder.
absl::StatusOr<std::vector<std::string>> FilesOfTile(const std::string& path);

// Where a tileset stands: the matrix from the frame of its root's parent to that of the scene, 16 numbers column by
// column. Empty: the tileset itself says it (common/codec/tiles3d/tileset_frame.h).
using TileFrame = std::vector<double>;

// The path of a file in the folder of the tile at `path`.
std::string FileBesideTile(const std::string& path, const std::string& name);

// The bytes of a mesh file, or the PackFiles of a tree. A frame that is not empty is a further file of a tileset, the
// last. Errors of ReadFile and FilesOfTile.
absl::StatusOr<std::string> ReadTileBytes(const std::string& path, const TileFrame& frame = {});

// The name of the file for the frame. No file of a tile has such a name.
inline constexpr char kFrameFile[] = ".frame";

// The frame in such a file; empty if it does not hold 16 numbers.
TileFrame FrameIn(std::string_view bytes);

// What ReadTileBytes would read, in bytes. Errors of LookAt and FilesOfTile.
absl::StatusOr<int64_t> SizeOfTile(const std::string& path, const TileFrame& frame = {});

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_TILE_FILES_H_
