#include "common/grid/scene.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <tuple>

#include "absl/status/status.h"
#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/grid/scene_sources.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/real_path.h"
#include "common/util/status_macros.h"

namespace tilemend {

void SortTiles(std::vector<SceneTile>* tiles) {
  std::sort(tiles->begin(), tiles->end(), [](const SceneTile& a, const SceneTile& b) {
    return std::tie(a.cell.row, a.cell.col) < std::tie(b.cell.row, b.cell.col);
  });
}

bool IsTileFormat(const std::string& path) {
  const std::string extension = absl::AsciiStrToLower(std::filesystem::path(path).extension().string());
  return extension == ".ply" || extension == ".obj" || extension == ".osgb";
}

absl::StatusOr<bool> IsThere(const std::string& path) {
  const auto found = LookAt(path);
  if (found.ok()) return true;
  if (IsObjectPath(path) && !absl::IsNotFound(found.status())) return found.status();
  if (!LookAt(path, Links::kKeep).ok()) return false;
  return absl::InvalidArgumentError(
      absl::StrCat(path, ": a link that leads to no file that can be read; remove it, or restore the file"));
}

std::string OutputPath(const SceneTile& tile) {
  if (!tile.delivered.empty()) return tile.delivered;
  if (!tile.path.empty()) return tile.path;
  return tile.output.empty() ? absl::StrCat("tiles/Tile_", ToString(tile.cell), ".ply") : tile.output;
}

namespace {

namespace fs = std::filesystem;

// Somebody else's folder of tiles may hold links to files of who runs this.
void WarnOfLinksOut(Scene& scene) {
  if (IsObjectPath(scene.root)) return;  // without links
  const fs::path root = RealPath(scene.root);
  const auto leads_out = [&](const fs::path& path) { return !IsBelow(root, RealPath(path)); };
  std::map<std::string, bool> folders;  // whether they lead out
  int64_t count = 0;
  std::string first;
  for (const SceneTile& tile : scene.tiles) {
    if (tile.path.empty()) continue;
    const fs::path file = fs::path(scene.root) / tile.path;
    const auto [folder, is_new] = folders.try_emplace(file.parent_path().string());
    if (is_new) folder->second = leads_out(file.parent_path());
    const auto look = LookAt(file.string(), Links::kKeep);
    const bool is_link = look.ok() && look->kind == PathKind::kOther;
    if (is_link ? !leads_out(file) : !folder->second) continue;
    if (count++ == 0) first = absl::StrCat(file.string(), " leads to ", RealPath(file).string());
  }
  if (count == 0) return;
  scene.warnings.push_back(absl::StrCat(first, ", out of the scene's folder",
                                        count > 1 ? absl::StrCat(", as do ", count - 1, " other tiles") : ""));
}

absl::StatusOr<Scene> Load(const std::string& path, const HullReader& read_hull, const TilesetReader& read_tileset) {
  const auto look = LookAt(path);
  if (absl::IsNotFound(look.status())) return absl::NotFoundError(absl::StrCat(path, ": no such scene"));
  if (!look.ok()) return look.status();
  if (look->kind == PathKind::kFolder) {
    const std::string json = (fs::path(path) / "scene.json").string();
    TILEMEND_ASSIGN_OR_RETURN(const bool has_json, IsThere(json));
    if (has_json) return ReadSceneJson(json, path);
    TILEMEND_ASSIGN_OR_RETURN(const std::string tileset, FindTileset(path));
    return tileset.empty() ? FindScene(path, read_hull) : FindTilesetScene(path, tileset, read_hull, read_tileset);
  }
  if (absl::AsciiStrToLower(fs::path(path).extension().string()) != ".json") {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": a scene is a folder of tiles or a scene.json; one mesh is for `tilemend fill`"));
  }
  std::string folder = fs::path(path).parent_path().string();
  if (folder.empty()) folder = ".";
  if (LooksLikeTileset(path)) {
    return FindTilesetScene(folder, fs::path(path).filename().string(), read_hull, read_tileset);
  }
  return ReadSceneJson(path, folder);
}

}  // namespace

absl::StatusOr<Scene> LoadScene(const std::string& path, const HullReader& read_hull,
                                const TilesetReader& read_tileset) {
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, Load(path, read_hull, read_tileset));
  // Outputs have it beside a scene.json, too. A scene.json that was written for tiles without numbers may leave the
  // place to it.
  const std::string metadata = (fs::path(scene.root) / "metadata.xml").string();
  TILEMEND_ASSIGN_OR_RETURN(const bool has_metadata, IsThere(metadata));
  if (has_metadata && !scene.found_by_name && scene.tileset.empty() && scene.crs.empty() && scene.origin.isZero(0)) {
    TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadFile(metadata));
    TILEMEND_RETURN_IF_ERROR(ParseMetadata(text, metadata, &scene));
  }
  WarnOfLinksOut(scene);
  return scene;
}

}  // namespace tilemend
