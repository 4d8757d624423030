#include "common/grid/scene.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <tuple>

#include "absl/status/status.h"
#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/grid/scene_sources.h"

namespace tilemend {

void SortTiles(std::vector<SceneTile>* tiles) {
  std::sort(tiles->begin(), tiles->end(), [](const SceneTile& a, const SceneTile& b) {
    return std::tie(a.cell.row, a.cell.col) < std::tie(b.cell.row, b.cell.col);
  });
}

bool IsTileFormat(const std::string& path) {
  const std::string extension = absl::AsciiStrToLower(std::filesystem::path(path).extension().string());
  return extension == ".ply" || extension == ".obj";
}

std::string OutputPath(const SceneTile& tile) {
  return tile.path.empty() ? absl::StrCat("tiles/Tile_", ToString(tile.cell), ".ply") : tile.path;
}

absl::StatusOr<Scene> LoadScene(const std::string& path, const BoundsReader& read_bounds) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return absl::NotFoundError(absl::StrCat(path, ": no such scene"));
  if (error) return absl::PermissionDeniedError(absl::StrCat(path, ": ", error.message()));
  if (status.type() == fs::file_type::directory) {
    const fs::path json = fs::path(path) / "scene.json";
    if (fs::exists(json, error)) return ReadSceneJson(json.string(), path);
    return FindScene(path, read_bounds);
  }
  if (absl::AsciiStrToLower(fs::path(path).extension().string()) != ".json") {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": a scene is a folder of tiles or a scene.json; one mesh is for `tilemend fill`"));
  }
  const std::string folder = fs::path(path).parent_path().string();
  return ReadSceneJson(path, folder.empty() ? "." : folder);
}

}  // namespace tilemend
