#include "common/grid/scene.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "absl/status/status.h"
#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/grid/scene_sources.h"
#include "common/util/folders.h"

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
  if (!tile.path.empty()) return tile.path;
  return tile.output.empty() ? absl::StrCat("tiles/Tile_", ToString(tile.cell), ".ply") : tile.output;
}

absl::StatusOr<Scene> LoadScene(const std::string& path, const BoundsReader& read_bounds) {
  namespace fs = std::filesystem;
  const auto look = LookAt(path);
  if (absl::IsNotFound(look.status())) return absl::NotFoundError(absl::StrCat(path, ": no such scene"));
  if (!look.ok()) return absl::PermissionDeniedError(look.status().message());
  if (look->kind == PathKind::kFolder) {
    const fs::path json = fs::path(path) / "scene.json";
    if (KindOf(json.string()) != PathKind::kNothing) return ReadSceneJson(json.string(), path);
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
