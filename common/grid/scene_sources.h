// The two ways to a scene, behind LoadScene.
#ifndef TILEMEND_COMMON_GRID_SCENE_SOURCES_H_
#define TILEMEND_COMMON_GRID_SCENE_SOURCES_H_

#include <string>

#include "absl/status/statusor.h"
#include "common/grid/scene.h"

namespace tilemend {

// Largest number of columns or rows: a limit on mistakes, not on memory.
inline constexpr int32_t kMaxCellsPerSide = 100000;

// Largest cell size and largest distance of the grid's corner from the origin, as of coordinates in tiles.
inline constexpr double kMostMetres = 1e9;

// Reads the file `json_path`; tile paths are relative to `root` and must exist there.
absl::StatusOr<Scene> ReadSceneJson(const std::string& json_path, const std::string& root);

// The scene that `text` describes; `name` stands in messages. Touches no file: paths are checked, not looked up.
absl::StatusOr<Scene> ParseSceneJson(const std::string& text, const std::string& name);

// CRS and origin from the text of a metadata.xml; `path` stands in messages.
absl::Status ParseMetadata(const std::string& text, const std::string& path, Scene* scene);

// Finds the tiles of a folder without scene.json by their names.
absl::StatusOr<Scene> FindScene(const std::string& root, const HullReader& read_hull);

// The file name of the tileset that a folder has: tileset.json, or the only .json file that is one; empty: none.
absl::StatusOr<std::string> FindTileset(const std::string& root);

// The scene of the tileset `entry` in a folder.
absl::StatusOr<Scene> FindTilesetScene(const std::string& root, const std::string& entry, const HullReader& read_hull,
                                       const TilesetReader& read_tileset);

// Whether a file is a tileset by what it has, whatever is wrong with it. Reads it.
bool LooksLikeTileset(const std::string& path);

// Numbers the cells from 0, as everywhere else, sorts the tiles and sets the extent. kInvalidArgument for too many.
absl::Status NumberCells(Scene* scene);

// Whether there is something at `path`. kInvalidArgument for a link that leads to nothing: who made it meant a file.
absl::StatusOr<bool> IsThere(const std::string& path);

// Sorts by (row, col), the order of Scene::tiles.
void SortTiles(std::vector<SceneTile>* tiles);

// Whether `path` ends in .ply, .obj or .osgb, in any case.
bool IsTileFormat(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_SCENE_SOURCES_H_
