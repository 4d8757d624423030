#include "client/output_tiles.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "absl/strings/str_cat.h"
#include "common/grid/scene_sources.h"
#include "common/records/output_names.h"
#include "common/util/folders.h"
#include "common/util/tile_files.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// The cells with a hole that the job filled.
std::set<CellId> FilledCells(const Json& report) {
  std::set<CellId> cells;
  const Json& holes = Member(report, "per_hole");
  if (!holes.is_array()) return cells;
  for (const Json& hole : holes) {
    const Json& cell = Member(hole, "cell");
    const bool is_cell =
        cell.is_array() && cell.size() == 2 && cell[0].is_number_integer() && cell[1].is_number_integer();
    if (is_cell && Text(Member(hole, "outcome")) == "filled") {
      cells.insert({cell[0].get<int32_t>(), cell[1].get<int32_t>()});
    }
  }
  return cells;
}

// Whether a file is the tile of its folder, and not a finer file of a tree.
bool IsTileOf(const std::string& folder, const std::string& name) {
  return IsTileFormat(name) && (!IsTileTree(name) || fs::path(name).stem() == fs::path(folder).filename());
}

// Adds the meshes in `folder` of `root`, and with `below` those in its folders.
void AddMeshes(const std::string& root, const std::string& folder, bool below, std::set<std::string>& meshes) {
  const auto names = ListFolder((fs::path(root) / folder).string());
  if (!names.ok()) return;
  for (const std::string& name : *names) {
    const std::string path = (fs::path(folder) / name).string();
    const auto look = LookAt((fs::path(root) / path).string(), Links::kKeep);
    if (!look.ok() || name.starts_with(kHiddenPrefix)) continue;
    if (look->kind == PathKind::kFile && IsTileOf(folder, name)) meshes.insert(path);
    if (look->kind == PathKind::kFolder && below) AddMeshes(root, path, below, meshes);
  }
}

// The meshes beside the tiles `own`: in the output's folder itself, and anywhere below the folders in it that hold
// tiles.
std::set<std::string> MeshesAmong(const std::set<std::string>& own, const std::string& root) {
  std::set<std::string> tops, meshes;
  for (const std::string& tile : own) {
    const fs::path path(tile);
    tops.insert(path.has_parent_path() ? path.begin()->string() : "");
  }
  for (const std::string& top : tops) AddMeshes(root, top, !top.empty(), meshes);
  return meshes;
}

}  // namespace

OutputTiles LookForTiles(const std::string& folder, const Json& report, const Scene& scene,
                         const std::set<CellId>& chosen) {
  const std::set<CellId> filled = FilledCells(report);
  OutputTiles tiles;
  std::set<std::string> own;
  for (const SceneTile& tile : scene.tiles) {
    const std::string path = fs::path(OutputPath(tile)).lexically_normal().string();
    own.insert(path);
    const bool due =
        (!tile.path.empty() || filled.contains(tile.cell)) && (chosen.empty() || chosen.contains(tile.cell));
    if (due && KindOf((fs::path(folder) / path).string()) != PathKind::kFile) tiles.missing.push_back(path);
  }
  std::sort(tiles.missing.begin(), tiles.missing.end());
  const std::set<std::string> meshes = MeshesAmong(own, folder);
  std::set_difference(meshes.begin(), meshes.end(), own.begin(), own.end(), std::back_inserter(tiles.others));
  return tiles;
}

}  // namespace tilemend
