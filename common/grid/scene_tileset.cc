#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/grid/grid_fit.h"
#include "common/grid/scene_sources.h"
#include "common/grid/tile_hulls.h"
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

// The distance of neighbours, tiles that begin at `lows` and are `size` wide in the median; `size` if there are none.
double PitchOf(std::vector<double> lows, double size) {
  std::ranges::sort(lows);
  std::vector<double> steps;
  for (size_t i = 1; i < lows.size(); ++i) {
    if (lows[i] - lows[i - 1] > size / 2) steps.push_back(lows[i] - lows[i - 1]);
  }
  return steps.empty() ? size : UpperMedian(std::move(steps));
}

// The cells of tiles without numbers in their names, by a grid along turned axes.
std::vector<CellId> CellsByPlace(const std::vector<ConvexHull>& hulls, double turn) {
  std::vector<Box> boxes;
  for (const ConvexHull& hull : hulls) boxes.push_back(BoundsOf(hull, turn));
  std::vector<CellId> cells(boxes.size());
  for (int k = 0; k < 2; ++k) {
    std::vector<double> sizes, lows;
    for (const Box& box : boxes) {
      sizes.push_back(box.hi[k] - box.lo[k]);
      lows.push_back(box.lo[k]);
    }
    const double least = *std::ranges::min_element(lows);
    const double pitch = PitchOf(std::move(lows), std::fmax(1, UpperMedian(std::move(sizes))));
    for (size_t t = 0; t < boxes.size(); ++t) {
      const double at = ((boxes[t].lo[k] + boxes[t].hi[k]) / 2 - least) / pitch;
      (k == 0 ? cells[t].col : cells[t].row) = static_cast<int32_t>(std::fmin(at, kMaxCellsPerSide));
    }
  }
  return cells;
}

// None if a name has no numbers.
absl::StatusOr<std::vector<CellId>> CellsInNames(const std::vector<TilesetTiles::Tile>& tiles) {
  std::vector<CellId> cells;
  for (const TilesetTiles::Tile& tile : tiles) {
    TILEMEND_ASSIGN_OR_RETURN(const std::optional<CellId> cell, CellInName(tile.path));
    if (!cell) return std::vector<CellId>();
    cells.push_back(*cell);
  }
  return cells;
}

// How the tiles of a tileset lie: the axes that they were cut along, and their cells there.
struct Cut {
  double turn = 0;
  std::vector<CellId> cells;        // of all tiles
  std::vector<TileHull> looked_at;  // in the frames that the tileset has by itself
  std::vector<size_t> tile_of;      // of each of these
};

// Exports in a map's frame are cut along its axes. The hulls' sides tell that, but so does the edge of a survey that
// lies askew: the axes are right along which neighbours fit together better. And their bounds are smaller there: by
// wider bounds, tiles that gape fit together better along any axes.
absl::StatusOr<Cut> FindCut(const std::string& root, const std::vector<TilesetTiles::Tile>& tiles,
                            const HullReader& read_hull) {
  Cut cut;
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<CellId> named, CellsInNames(tiles));
  const bool has_names = !named.empty();
  cut.tile_of = TilesToLookAt(has_names ? named : std::vector<CellId>());
  if (!has_names) {
    for (size_t t = 0; t < tiles.size(); ++t) cut.tile_of.push_back(t);
  }
  std::vector<ConvexHull> hulls;
  for (const size_t t : cut.tile_of) {
    TILEMEND_ASSIGN_OR_RETURN(hulls.emplace_back(), read_hull(absl::StrCat(root, "/", tiles[t].path), tiles[t].frame));
  }
  double least_gap = INFINITY, side = 0;
  std::vector<double> turns = {0, TurnOfSides(hulls)};
  if (has_names) turns.insert(turns.end(), {turns[1] + std::numbers::pi / 2, turns[1] - std::numbers::pi / 2});
  for (const double turn : turns) {
    const std::vector<CellId> cells = has_names ? named : CellsByPlace(hulls, turn);
    std::vector<TileHull> placed;
    for (size_t k = 0; k < hulls.size(); ++k) placed.push_back({cells[cut.tile_of[k]], hulls[k]});
    const double gap = MedianGap(placed, turn);
    if (!cut.cells.empty() && !(gap < least_gap && MedianSide(placed, turn) <= side)) continue;
    least_gap = gap;
    side = MedianSide(placed, turn);
    cut.turn = turn;
    cut.cells = cells;
    cut.looked_at = std::move(placed);
  }
  return cut;
}

std::string AxesWarning(const Scene& scene, double turn) {
  return absl::StrFormat(
      "%s/%s: its tiles were cut along axes that are turned by %.3f degrees against its own, as those of a map are; "
      "the scene's x and y follow the cut",
      scene.root, scene.tileset, turn * 180 / std::numbers::pi);
}

// A cell for each tile of a tileset.
absl::Status AddCells(const TilesetTiles& tilesets, const Cut& cut, const std::string& entry, Scene* scene) {
  const std::vector<CellId>& cells = cut.cells;
  std::map<CellId, std::string> taken;
  for (size_t t = 0; t < cells.size(); ++t) {
    const TilesetTiles::Tile& tile = tilesets.tiles[t];
    if (const auto [at, fresh] = taken.emplace(cells[t], tile.path); !fresh) {
      return absl::InvalidArgumentError(
          absl::StrCat(scene->root, "/", entry, ": ", at->second, " and ", tile.path, " are both in cell ",
                       ToString(cells[t]), "; the tilesets have to lie in a regular plane grid, one in each cell"));
    }
    scene->tiles.push_back({cells[t], tile.path});
    scene->tiles.back().frame = tile.frame;
  }
  std::vector<PlacedTile> placed;
  for (size_t k = 0; k < cut.tile_of.size(); ++k) {
    placed.push_back(
        {cut.looked_at[k].cell, tilesets.tiles[cut.tile_of[k]].path, BoundsOf(cut.looked_at[k].hull, cut.turn)});
  }
  TILEMEND_ASSIGN_OR_RETURN(scene->grid, FitGrid(std::move(placed)));
  scene->tileset = entry;
  if (cut.turn != 0) scene->warnings.push_back(AxesWarning(*scene, cut.turn));
  scene->warnings.push_back(absl::StrFormat("%s/%s: %d tilesets as cells of %.10g x %.10g m, grid corner %.10g, %.10g",
                                            scene->root, entry, cells.size(), scene->grid.cell_size.x(),
                                            scene->grid.cell_size.y(), scene->grid.corner.x(), scene->grid.corner.y()));
  return absl::OkStatus();
}

void AddWhole(const TilesetTiles::Tile& tile, const Box& bounds, Scene* scene) {
  scene->tiles.push_back({{0, 0}, tile.path});
  for (int k = 0; k < 2; ++k) {
    scene->grid.corner[k] = std::floor(bounds.lo[k]);
    scene->grid.cell_size[k] = std::fmax(1, std::ceil(bounds.hi[k]) - scene->grid.corner[k]);
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

absl::StatusOr<Scene> FindTilesetScene(const std::string& root, const std::string& entry, const HullReader& read_hull,
                                       const TilesetReader& read_tileset) {
  if (!read_tileset || !read_hull) {
    return absl::FailedPreconditionError(absl::StrCat(root, ": no scene.json, and no tileset reader"));
  }
  TILEMEND_ASSIGN_OR_RETURN(TilesetTiles tilesets, read_tileset(root, entry, 0));
  const bool is_whole = tilesets.tiles.size() == 1 && tilesets.tiles[0].path == entry;
  Cut cut;
  if (!is_whole) {
    TILEMEND_ASSIGN_OR_RETURN(cut, FindCut(root, tilesets.tiles, read_hull));
    if (cut.turn != 0) {
      TILEMEND_ASSIGN_OR_RETURN(tilesets, read_tileset(root, entry, cut.turn));
    }
  }
  Scene scene;
  scene.root = root;
  scene.found_by_name = true;
  scene.crs = tilesets.crs;
  scene.origin.z() = tilesets.height;
  if (!tilesets.warning.empty()) scene.warnings.push_back(tilesets.warning);
  if (is_whole) {
    TILEMEND_ASSIGN_OR_RETURN(const ConvexHull hull, read_hull(absl::StrCat(root, "/", entry), {}));
    AddWhole(tilesets.tiles[0], BoundsOf(hull, 0), &scene);
  } else {
    TILEMEND_RETURN_IF_ERROR(AddCells(tilesets, cut, entry, &scene));
  }
  TILEMEND_RETURN_IF_ERROR(NumberCells(&scene));
  return scene;
}

}  // namespace tilemend
