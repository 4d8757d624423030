#include "common/grid/scene_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/grid/scene_sources.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr double kLeastShare = 0.01;  // of a square
constexpr double kWhole = 0.9999;     // of a square: what is drawn along the grid is off it by rounding
constexpr int64_t kMostSquares = 1000000;
// Squares without a tile that an area may add: so many, and so many for each tile.
constexpr int64_t kMostAdded = 10000, kMostAddedForTile = 20;
constexpr int kLines = 16;  // that measure a share

// The squares [from, to) that the polygon's bounds touch.
struct Squares {
  CellId from, to;
  int64_t count() const { return int64_t{to.col - from.col} * (to.row - from.row); }
};

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

// Where the line at `y` is inside, in order: from, to, from, to, ...
std::vector<double> Crossings(const PlanePolygon& area, double y) {
  std::vector<double> at;
  for (const std::vector<Point2>& ring : area.rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y() <= y) == (b.y() <= y)) continue;
      at.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

// The share of each square of a row that is inside, in order of the columns.
std::vector<double> SharesOfRow(const PlanePolygon& area, const Grid& grid, const Squares& squares, int32_t row) {
  std::vector<double> shares(squares.to.col - squares.from.col);
  for (int k = 0; k < kLines; ++k) {
    const double y = grid.corner.y() + (row + (k + 0.5) / kLines) * grid.cell_size.y();
    const std::vector<double> at = Crossings(area, y);
    for (size_t i = 0; i + 1 < at.size(); i += 2) {
      const double from = (at[i] - grid.corner.x()) / grid.cell_size.x() - squares.from.col;
      const double to = (at[i + 1] - grid.corner.x()) / grid.cell_size.x() - squares.from.col;
      for (auto c = static_cast<size_t>(std::max(0.0, from)); c < shares.size() && static_cast<double>(c) < to; ++c) {
        const auto left = static_cast<double>(c);
        shares[c] += std::max(0.0, std::min(to, left + 1) - std::max(from, left)) / kLines;
      }
    }
  }
  return shares;
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

// Whether an area is of this scene: it covers cells of it, and does not add very many.
absl::Status CheckReach(double covered, int64_t added, int64_t cells) {
  if (covered <= 0) {
    return absl::InvalidArgumentError("the area covers no cell of the scene; are its coordinates those of this scene?");
  }
  if (added > kMostAdded + kMostAddedForTile * cells) {
    return absl::InvalidArgumentError(
        absl::StrCat("the area adds ", added, " cells without a tile to ", cells, "; draw it nearer around the tiles"));
  }
  return absl::OkStatus();
}

// `covered` and `cells` of the scene in squares.
void WarnOfLittle(double covered, int64_t cells, int64_t slivers, Scene& scene) {
  const double square = scene.grid.cell_size.prod(), all = static_cast<double>(cells);
  if (covered < kLeastShare * all) {
    scene.warnings.push_back(
        absl::StrFormat("the area covers %.2f m2 of the %.0f m2 of the scene's cells: nothing else is filled",
                        covered * square, all * square));
  }
  if (slivers > 0) {
    scene.warnings.push_back(absl::StrCat("the area covers less than 1 % of ", slivers,
                                          " squares of the grid without a tile: they stay outside"));
  }
}

}  // namespace

absl::Status CoverArea(PlanePolygon area, Scene& scene) {
  const auto squares = SquaresOf(area, scene.grid);
  if (!squares.ok()) return squares.status();
  std::set<CellId> missing, known;
  for (const SceneTile& tile : scene.tiles) known.insert(tile.cell);
  double over_scene = 0;
  int64_t whole = 0, slivers = 0;
  for (int32_t row = squares->from.row; row < squares->to.row; ++row) {
    const std::vector<double> shares = SharesOfRow(area, scene.grid, *squares, row);
    for (size_t c = 0; c < shares.size(); ++c) {
      const CellId cell{squares->from.col + static_cast<int32_t>(c), row};
      over_scene += known.contains(cell) ? shares[c] : 0;
      whole += shares[c] >= kWhole;
      if (shares[c] <= 0 || known.contains(cell)) continue;
      if (shares[c] < kLeastShare) ++slivers;
      if (shares[c] >= kLeastShare) missing.insert(cell);
    }
  }
  TILEMEND_RETURN_IF_ERROR(CheckReach(over_scene, std::ssize(missing), std::ssize(known)));
  scene.area = {};
  CellId low{0, 0};
  for (const CellId cell : missing) {
    low = {std::min(low.col, cell.col), std::min(low.row, cell.row)};
    scene.cols = std::max(scene.cols, cell.col + 1);
    scene.rows = std::max(scene.rows, cell.row + 1);
    scene.tiles.push_back({.cell = cell, .path = "", .added = true});
  }
  ShiftNumbering({-low.col, -low.row}, scene);
  SortTiles(&scene.tiles);
  TILEMEND_RETURN_IF_ERROR(CheckNames(scene));
  WarnOfLittle(over_scene, std::ssize(known), slivers, scene);
  if (whole < std::ssize(scene.tiles)) scene.area = std::move(area);
  scene.area_known = true;
  return absl::OkStatus();
}

}  // namespace tilemend
