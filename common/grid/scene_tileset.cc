#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/grid/grid_fit.h"
#include "common/grid/scene_sources.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

constexpr char kTilesetFile[] = "tileset.json";
constexpr int64_t kMostBytes = int64_t{64} << 20;  // of a file that may be a tileset

// Takes "_p003", "_m003", "_+003" or "_-003" off the end of a name.
std::optional<int32_t> TakeNumber(std::string_view& name) {
  const size_t underscore = name.rfind('_');
  if (underscore == std::string_view::npos || underscore + 2 >= name.size()) return std::nullopt;
  const char sign = name[underscore + 1];
  if (std::string_view("pm+-").find(sign) == std::string_view::npos) return std::nullopt;
  uint32_t value = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + underscore + 2, end, value);
  if (error != std::errc() || stop != end || value >= static_cast<uint32_t>(kMaxCellsPerSide)) return std::nullopt;
  name.remove_suffix(name.size() - underscore);
  return sign == 'm' || sign == '-' ? -static_cast<int32_t>(value) : static_cast<int32_t>(value);
}

// The cell that the name of a tileset or of its folder says. kInvalidArgument for a name with three numbers.
absl::StatusOr<std::optional<CellId>> CellInName(const std::string& path) {
  const fs::path file(path);
  for (const std::string& text : {file.stem().string(), file.parent_path().filename().string()}) {
    std::string_view name = text;
    const std::optional<int32_t> row = TakeNumber(name);
    const std::optional<int32_t> col = row ? TakeNumber(name) : std::nullopt;
    if (!col) continue;
    if (TakeNumber(name)) {
      return absl::InvalidArgumentError(absl::StrCat(path, ": a name with three numbers, as of tiles that are cut in ",
                                                     "height, too; export tiles of a plane grid"));
    }
    return std::optional<CellId>({*col, *row});
  }
  return std::optional<CellId>();
}

double MiddleOne(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<int64_t>(values.size()) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The cells of tiles without numbers in their names, by a grid of the median tile's size.
std::vector<CellId> CellsByPlace(const std::vector<TilesetTiles::Tile>& tiles) {
  std::vector<CellId> cells(tiles.size());
  for (int k = 0; k < 2; ++k) {
    std::vector<double> sizes;
    double least = tiles[0].bounds.lo[k];
    for (const TilesetTiles::Tile& tile : tiles) {
      sizes.push_back(tile.bounds.hi[k] - tile.bounds.lo[k]);
      least = std::min(least, tile.bounds.lo[k]);
    }
    const double size = std::fmax(1, MiddleOne(std::move(sizes)));
    for (size_t t = 0; t < tiles.size(); ++t) {
      const double at = ((tiles[t].bounds.lo[k] + tiles[t].bounds.hi[k]) / 2 - least) / size;
      (k == 0 ? cells[t].col : cells[t].row) = static_cast<int32_t>(std::fmin(at, kMaxCellsPerSide));
    }
  }
  return cells;
}

absl::StatusOr<std::vector<CellId>> CellsOf(const std::vector<TilesetTiles::Tile>& tiles) {
  std::vector<CellId> cells;
  for (const TilesetTiles::Tile& tile : tiles) {
    TILEMEND_ASSIGN_OR_RETURN(const std::optional<CellId> cell, CellInName(tile.path));
    if (!cell) return CellsByPlace(tiles);
    cells.push_back(*cell);
  }
  return cells;
}

// A cell for each tile of a tileset.
absl::Status AddCells(const TilesetTiles& tilesets, const std::string& entry, Scene* scene) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<CellId> cells, CellsOf(tilesets.tiles));
  std::map<CellId, std::string> taken;
  std::vector<PlacedTile> placed;
  for (size_t t = 0; t < cells.size(); ++t) {
    const TilesetTiles::Tile& tile = tilesets.tiles[t];
    if (const auto [at, fresh] = taken.emplace(cells[t], tile.path); !fresh) {
      return absl::InvalidArgumentError(
          absl::StrCat(scene->root, "/", entry, ": ", at->second, " and ", tile.path, " are both in cell ",
                       ToString(cells[t]), "; the tilesets have to lie in a regular plane grid, one in each cell"));
    }
    scene->tiles.push_back({cells[t], tile.path});
    scene->tiles.back().frame = tile.frame;
    placed.push_back({cells[t], tile.path, tile.bounds});
  }
  TILEMEND_ASSIGN_OR_RETURN(scene->grid, FitGrid(std::move(placed)));
  scene->tileset = entry;
  scene->warnings.push_back(absl::StrFormat("%s/%s: %d tilesets as cells of %.10g x %.10g m, grid corner %.10g, %.10g",
                                            scene->root, entry, cells.size(), scene->grid.cell_size.x(),
                                            scene->grid.cell_size.y(), scene->grid.corner.x(), scene->grid.corner.y()));
  return absl::OkStatus();
}

void AddWhole(const TilesetTiles::Tile& tile, Scene* scene) {
  scene->tiles.push_back({{0, 0}, tile.path});
  for (int k = 0; k < 2; ++k) {
    scene->grid.corner[k] = std::floor(tile.bounds.lo[k]);
    scene->grid.cell_size[k] = std::fmax(1, std::ceil(tile.bounds.hi[k]) - scene->grid.corner[k]);
  }
  scene->warnings.push_back(absl::StrFormat("%s/%s: the tileset is one cell of %.10g x %.10g m", scene->root, tile.path,
                                            scene->grid.cell_size.x(), scene->grid.cell_size.y()));
}

}  // namespace

bool LooksLikeTileset(const std::string& path) {
  const auto look = LookAt(path);
  if (!IsTileset(path) || !look.ok() || look->kind != PathKind::kFile || look->size > kMostBytes) return false;
  const auto text = ReadFile(path);
  if (!text.ok()) return false;
  const auto json = nlohmann::json::parse(*text, nullptr, /*allow_exceptions=*/false);
  return json.is_object() && json.contains("asset") && json.contains("root") && json["root"].is_object();
}

absl::StatusOr<std::string> FindTileset(const std::string& root) {
  TILEMEND_ASSIGN_OR_RETURN(const bool has_usual, IsThere((fs::path(root) / kTilesetFile).string()));
  if (has_usual) return kTilesetFile;
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::string> names, ListFolder(root));
  std::string found;
  for (const std::string& name : names) {
    if (!IsTileset(name) || !LooksLikeTileset((fs::path(root) / name).string())) continue;
    if (!found.empty()) {
      return absl::InvalidArgumentError(
          absl::StrCat(root, ": ", found, " and ", name, " are both tilesets; give the path of one"));
    }
    found = name;
  }
  return found;
}

absl::StatusOr<Scene> FindTilesetScene(const std::string& root, const std::string& entry,
                                       const TilesetReader& read_tileset) {
  if (!read_tileset) return absl::FailedPreconditionError(absl::StrCat(root, ": no scene.json, and no tileset reader"));
  TILEMEND_ASSIGN_OR_RETURN(const TilesetTiles tilesets, read_tileset(root, entry));
  Scene scene;
  scene.root = root;
  scene.found_by_name = true;
  scene.crs = tilesets.crs;
  scene.origin.z() = tilesets.height;
  if (!tilesets.warning.empty()) scene.warnings.push_back(tilesets.warning);
  if (tilesets.tiles.size() == 1 && tilesets.tiles[0].path == entry) {
    AddWhole(tilesets.tiles[0], &scene);
  } else {
    TILEMEND_RETURN_IF_ERROR(AddCells(tilesets, entry, &scene));
  }
  TILEMEND_RETURN_IF_ERROR(NumberCells(&scene));
  return scene;
}

}  // namespace tilemend
