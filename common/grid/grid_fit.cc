#include "common/grid/grid_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace tilemend {
namespace {

// Pairs this far apart in the order of tiles are compared: enough to average zigzag borders out, and linear in the
// tiles.
constexpr size_t kPairReach = 16;
// A tile with this share of the pitch reaches both of its borders, so that its middle is the middle of its cell.
constexpr double kFullShare = 0.98;
// Rounding never moves a value further than this share of the cell size, whatever the scatter.
constexpr double kLargestRounding = 0.005;
// Float32 bounds scatter by about this share of the cell size even where the cut was exact.
constexpr double kNumberNoise = 1e-6;
// Tiles of one column are as wide as the rows are high, give or take an overlap: the cells are square.
constexpr double kSquareTolerance = 0.05;

double Low(const PlacedTile& tile, int axis) { return tile.bounds.lo[axis]; }
double High(const PlacedTile& tile, int axis) { return tile.bounds.hi[axis]; }
int32_t Index(const PlacedTile& tile, int axis) { return axis == 0 ? tile.cell.col : tile.cell.row; }

// The median; of an even number, the mean of the middle two. `values` is not empty.
double Median(std::vector<double> values) {
  const size_t middle = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + middle, values.end());
  const double upper = values[middle];
  if (values.size() % 2 == 1) return upper;
  return (upper + *std::max_element(values.begin(), values.begin() + middle)) / 2;
}

struct Estimate {
  double value = 0;
  double scatter = 0;  // median absolute deviation
};

Estimate Summarise(const std::vector<double>& values) {
  Estimate estimate{Median(values), 0};
  std::vector<double> deviations;
  deviations.reserve(values.size());
  for (const double v : values) deviations.push_back(std::abs(v - estimate.value));
  estimate.scatter = Median(std::move(deviations));
  return estimate;
}

// The multiple of the coarsest decimal step (100, 50, 10, 5, 1, 0.5, ... 0.001 m) within the estimate's scatter.
double RoundSensibly(const Estimate& estimate, double pitch) {
  const double tolerance = std::min(2 * estimate.scatter + kNumberNoise * pitch, kLargestRounding * pitch);
  for (const double steps_per_100 : {1., 2., 10., 20., 100., 200., 1000., 2000., 1e4, 1e5}) {
    const double rounded = std::round(estimate.value * steps_per_100 / 100) * 100 / steps_per_100;
    if (std::abs(rounded - estimate.value) <= tolerance) return rounded + 0.0;  // never -0
  }
  return estimate.value;
}

// Differences of bounds per step of the index; empty if there is one column (row) only. Sorts `tiles` along the axis.
std::vector<double> Slopes(int axis, std::vector<PlacedTile>* tiles) {
  std::sort(tiles->begin(), tiles->end(), [axis](const PlacedTile& a, const PlacedTile& b) {
    return std::tuple(Index(a, 1 - axis), Index(a, axis)) < std::tuple(Index(b, 1 - axis), Index(b, axis));
  });
  std::vector<double> slopes;
  for (size_t i = 0; i < tiles->size(); ++i) {
    for (size_t j = i + 1; j < tiles->size() && j <= i + kPairReach; ++j) {
      const PlacedTile& a = (*tiles)[i];
      const PlacedTile& b = (*tiles)[j];
      const double steps = Index(b, axis) - Index(a, axis);
      if (steps == 0) continue;
      slopes.push_back((Low(b, axis) - Low(a, axis)) / steps);
      slopes.push_back((High(b, axis) - High(a, axis)) / steps);
    }
  }
  return slopes;
}

Estimate Extent(int axis, const std::vector<PlacedTile>& tiles) {
  std::vector<double> extents;
  for (const PlacedTile& tile : tiles) extents.push_back(High(tile, axis) - Low(tile, axis));
  return Summarise(extents);
}

// Where the cell with index 0 begins.
double Corner(int axis, double pitch, const std::vector<PlacedTile>& tiles) {
  std::vector<double> corners;
  for (const PlacedTile& tile : tiles) {
    if (High(tile, axis) - Low(tile, axis) < kFullShare * pitch) continue;
    corners.push_back((Low(tile, axis) + High(tile, axis)) / 2 - (Index(tile, axis) + 0.5) * pitch);
  }
  if (corners.empty()) {
    // Every tile is cut short by holes: the corner lies where all fit into their cells.
    double least = INFINITY;
    double most = -INFINITY;
    for (const PlacedTile& tile : tiles) {
      least = std::min(least, Low(tile, axis) - Index(tile, axis) * pitch);
      most = std::max(most, High(tile, axis) - (Index(tile, axis) + 1) * pitch);
    }
    return (least + most) / 2;
  }
  return RoundSensibly(Summarise(corners), pitch);
}

absl::Status CheckTile(const PlacedTile& tile, const Grid& grid) {
  bool is_inside = true;
  for (const int axis : {0, 1}) {
    const double size = grid.cell_size[axis], begin = grid.corner[axis] + Index(tile, axis) * size;
    is_inside = is_inside && Low(tile, axis) >= begin - kReachBeyondCell * size &&
                High(tile, axis) <= begin + (1 + kReachBeyondCell) * size;
  }
  if (is_inside) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrFormat(
      "%s: reaches more than a quarter of a cell beyond cell %s of the grid that was found from the other tiles (cell "
      "size %g x %g, corner %g, %g): its bounds are x %.3f to %.3f, y %.3f to %.3f",
      tile.name, ToString(tile.cell), grid.cell_size.x(), grid.cell_size.y(), grid.corner.x(), grid.corner.y(),
      Low(tile, 0), High(tile, 0), Low(tile, 1), High(tile, 1)));
}

// The pitch along each axis; 0 where there is one column (row) only.
absl::StatusOr<Point2> Pitches(std::vector<PlacedTile>* tiles) {
  Point2 pitch(0, 0);
  for (const int axis : {0, 1}) {
    const std::vector<double> slopes = Slopes(axis, tiles);
    if (slopes.empty()) continue;
    const Estimate estimate = Summarise(slopes);
    pitch[axis] = RoundSensibly(estimate, estimate.value);
    if (!(pitch[axis] > 0)) {
      return absl::InvalidArgumentError(absl::StrCat(tiles->front().name, ": the ", axis == 0 ? "columns" : "rows",
                                                     " in the tiles' names do not follow the tiles' ",
                                                     axis == 0 ? "x" : "y", " coordinates"));
    }
  }
  return pitch;
}

// The size of the only column (row). `other`: the pitch along the other axis, or 0.
double SizeOfOne(int axis, double other, const std::vector<PlacedTile>& tiles) {
  const Estimate extent = Extent(axis, tiles);
  double lowest = INFINITY, highest = -INFINITY, first = INFINITY, last = -INFINITY;
  for (const PlacedTile& tile : tiles) {
    const double middle = (Low(tile, axis) + High(tile, axis)) / 2;
    lowest = std::min(lowest, Low(tile, axis));
    highest = std::max(highest, High(tile, axis));
    first = std::min(first, middle);
    last = std::max(last, middle);
  }
  // A survey that lies askew has less than a cell in each tile, and not at the same place.
  const bool is_askew = last - first > extent.value / 2 && highest - lowest <= (1 + kSquareTolerance) * other;
  const bool is_square = is_askew || std::abs(extent.value - other) <= kSquareTolerance * other;
  return is_square ? other : RoundSensibly(extent, extent.value);
}

}  // namespace

absl::StatusOr<Grid> FitGrid(std::vector<PlacedTile> tiles) {
  const absl::StatusOr<Point2> pitch = Pitches(&tiles);
  if (!pitch.ok()) return pitch.status();
  Grid grid;
  for (const int axis : {0, 1}) {
    double& size = grid.cell_size[axis];
    size = (*pitch)[axis];
    if (size == 0) {
      size = SizeOfOne(axis, (*pitch)[1 - axis], tiles);
    }
    if (!(size > 0) || !std::isfinite(size)) {
      return absl::InvalidArgumentError(absl::StrCat(tiles.front().name, ": the tiles have no extent along ",
                                                     axis == 0 ? "x" : "y", ", so that the cell size is not known"));
    }
    grid.corner[axis] = Corner(axis, size, tiles);
  }
  for (const PlacedTile& tile : tiles) {
    if (absl::Status status = CheckTile(tile, grid); !status.ok()) return status;
  }
  return grid;
}

}  // namespace tilemend
