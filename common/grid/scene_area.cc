#include "common/grid/scene_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/grid/area_shares.h"
#include "common/grid/scene_sources.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr double kLeastShare = 0.01;  // of a square
constexpr double kWhole = 0.9999;     // of a square: what is drawn along the grid is off it by rounding
constexpr int64_t kMostSquares = 1000000;
// Squares without a tile that an area may add: so many, and so many for each tile.
constexpr int64_t kMostAdded = 10000, kMostAddedForTile = 20;
constexpr double kMuch = 0.25;  // of an area, in cells that have no tile

// The squares that the polygon's bounds touch.
absl::StatusOr<Squares> SquaresOf(const PlanePolygon& area, const Grid& grid) {
  Point2 lo = Point2::Constant(std::numeric_limits<double>::infinity()), hi = -lo;
  for (const std::vector<Point2>& ring : area.rings) {
    for (const Point2& p : ring) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
  }
  const Point2 first = ((lo - grid.corner).array() / grid.cell_size.array()).floor();
  const Point2 last = ((hi - grid.corner).array() / grid.cell_size.array()).ceil();
  const Point2 count = last - first;
  if (!(count.prod() <= static_cast<double>(kMostSquares)) || last.cwiseAbs().maxCoeff() > kMaxCellsPerSide ||
      first.cwiseAbs().maxCoeff() > kMaxCellsPerSide) {
    return absl::InvalidArgumentError(
        absl::StrCat("the area spans ", count.x(), " x ", count.y(), " squares of the grid; is it of this scene?"));
  }
  return Squares{{static_cast<int32_t>(first.x()), static_cast<int32_t>(first.y())},
                 {static_cast<int32_t>(last.x()), static_cast<int32_t>(last.y())}};
}

// The files of cells without a tile keep the numbers that go with those of the tiles.
void ShiftNumbering(CellId by, Scene& scene) {
  if (by == CellId{0, 0}) return;
  for (SceneTile& tile : scene.tiles) {
    if (tile.path.empty()) tile.output = OutputPath(tile);
    tile.cell.col += by.col;
    tile.cell.row += by.row;
  }
  scene.grid.corner -= scene.grid.cell_size.cwiseProduct(Point2(by.col, by.row));
  scene.cols += by.col;
  scene.rows += by.row;
  scene.warnings.push_back(absl::StrCat("the area begins ", by.col, " columns west and ", by.row,
                                        " rows south of the grid: cells are numbered from there"));
}

// A cell without a tile gets a name of its own, which another tile may have.
absl::Status CheckNames(const Scene& scene) {
  std::set<std::string> names;
  for (const SceneTile& tile : scene.tiles) {
    if (names.insert(OutputPath(tile)).second) continue;
    return absl::InvalidArgumentError(absl::StrCat("cell ", ToString(tile.cell),
                                                   ", which the area adds, would be written as ", OutputPath(tile),
                                                   ", which is the file of another cell; rename that file"));
  }
  return absl::OkStatus();
}

// What of an area lies where, in squares.
struct Cover {
  double all = 0;       // in all squares
  double of_scene = 0;  // in cells of the scene
  double added = 0;     // in `missing`
  int64_t whole = 0;    // squares that are covered whole
  int64_t slivers = 0;  // squares that are covered too little to become cells
  std::set<CellId> missing;
};

Cover CoverOf(const PlanePolygon& area, const Squares& squares, const std::set<CellId>& known, const Grid& grid) {
  Cover cover;
  const std::vector<double> shares = SharesOf(area, grid, squares);
  for (size_t i = 0; i < shares.size(); ++i) {
    const auto at = static_cast<int32_t>(i);
    const CellId cell{squares.from.col + at % squares.cols(), squares.from.row + at / squares.cols()};
    cover.all += shares[i];
    cover.whole += shares[i] >= kWhole;
    if (known.contains(cell)) {
      cover.of_scene += shares[i];
    } else if (shares[i] >= kLeastShare) {
      cover.missing.insert(cell);
      cover.added += shares[i];
    } else if (shares[i] > 1 - kWhole) {
      ++cover.slivers;
    }
  }
  return cover;
}

// Whether an area is of this scene: it covers cells of it, and does not add very many.
absl::Status CheckReach(const Cover& cover, int64_t cells) {
  if (cover.all <= 0) return absl::InvalidArgumentError("the area is too small: it covers nothing");
  if (cover.of_scene <= 0) {
    return absl::InvalidArgumentError("the area covers no cell of the scene; are its coordinates those of this scene?");
  }
  if (const int64_t added = std::ssize(cover.missing); added > kMostAdded + kMostAddedForTile * cells) {
    return absl::InvalidArgumentError(
        absl::StrCat("the area adds ", added, " cells without a tile to ", cells, "; draw it nearer around the tiles"));
  }
  return absl::OkStatus();
}

// `cells` of the scene.
void WarnOfReach(const Cover& cover, int64_t cells, Scene& scene) {
  const double square = scene.grid.cell_size.prod(), all = static_cast<double>(cells);
  if (cover.of_scene < kLeastShare * all) {
    scene.warnings.push_back(absl::StrFormat(
        "the area is small: it covers %.2f m2 of the %.0f m2 of the scene's cells: nothing else is filled",
        cover.of_scene * square, all * square));
  }
  if (cover.slivers > 0) {
    scene.warnings.push_back(absl::StrCat("the area covers less than 1 % of ", cover.slivers,
                                          " squares of the grid without a tile: they stay outside"));
  }
  if (cover.added >= kMuch * cover.all) {
    scene.warnings.push_back(absl::StrFormat(
        "%.0f %% of the area (%.0f of %.0f m2) lies in cells that have no tile, where the fill has little to go by; "
        "draw it nearer around the tiles (tilemend inspect --propose-area FILE draws a first one)",
        100 * cover.added / cover.all, cover.added * square, cover.all * square));
  }
}

// Makes squares cells without surface.
void AddCells(const std::set<CellId>& missing, Scene& scene) {
  CellId low{0, 0};
  for (const CellId cell : missing) {
    low = {std::min(low.col, cell.col), std::min(low.row, cell.row)};
    scene.cols = std::max(scene.cols, cell.col + 1);
    scene.rows = std::max(scene.rows, cell.row + 1);
    scene.tiles.push_back({.cell = cell, .path = "", .added = true});
  }
  ShiftNumbering({-low.col, -low.row}, scene);
  SortTiles(&scene.tiles);
}

// The plan asks of each ring which others it lies in, which looks at all vertices: seconds, up to this.
constexpr size_t kMostRingChecks = 1'000'000'000;

absl::Status CheckRings(const PlanePolygon& area) {
  size_t vertices = 0;
  for (const std::vector<Point2>& ring : area.rings) vertices += ring.size();
  if (vertices == 0 || area.rings.size() <= kMostRingChecks / vertices) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat("an area of ", area.rings.size(), " rings with ", vertices,
                                                 " vertices; draw it with fewer holes, or coarser"));
}

}  // namespace

absl::Status CoverArea(PlanePolygon area, Scene& scene) {
  TILEMEND_RETURN_IF_ERROR(CheckRings(area));
  const auto squares = SquaresOf(area, scene.grid);
  if (!squares.ok()) return squares.status();
  std::set<CellId> known;
  for (const SceneTile& tile : scene.tiles) known.insert(tile.cell);
  const Cover cover = CoverOf(area, *squares, known, scene.grid);
  TILEMEND_RETURN_IF_ERROR(CheckReach(cover, std::ssize(known)));
  scene.area = {};
  AddCells(cover.missing, scene);
  TILEMEND_RETURN_IF_ERROR(CheckNames(scene));
  WarnOfReach(cover, std::ssize(known), scene);
  if (cover.whole < std::ssize(scene.tiles)) scene.area = std::move(area);
  scene.area_known = true;
  return absl::OkStatus();
}

}  // namespace tilemend
