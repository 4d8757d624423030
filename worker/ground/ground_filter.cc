#include "worker/ground/ground_filter.h"

#include <algorithm>
#include <utility>

#include "worker/ground/disk_opening.h"
#include "worker/ground/object_squares.h"

namespace tilemend {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr int32_t kUnitRadii = 10;      // squares: up to here radii grow by one
constexpr double kMinSight = 4.5;       // squares: the window has at most two where these are large
constexpr double kFinestStep = 0x1p-6;  // metres
constexpr double kMostSteps = 0x7ff0;   // to either side of the middle, of an int16

// Heights over the middle of their range, in power-of-two steps.
struct Steps {
  double middle = 0, step = kFinestStep;

  explicit Steps(const std::vector<float>& heights) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const float h : heights) {
      if (std::isnan(h)) continue;
      low = std::min<double>(low, h);
      high = std::max<double>(high, h);
    }
    if (low > high) return;
    while ((high - low) / 2 / step > kMostSteps) step *= 2;
    middle = std::round((low + high) / 2 / step) * step;
  }
};

StepRaster InSteps(const GroundRaster& raster, const Steps& steps) {
  StepRaster result{raster.cols, raster.rows, {}};
  result.heights.reserve(raster.heights.size());
  for (const float h : raster.heights) {
    result.heights.push_back(std::isnan(h) ? kNoSurface
                                           : static_cast<int16_t>(std::lround((h - steps.middle) / steps.step)));
  }
  return result;
}

// In squares, up to the window: by one at first, later by a tenth to a fifth.
std::vector<int32_t> Radii(double window, double square) {
  const auto last = std::max(1, static_cast<int32_t>(std::lround(window / square)));
  std::vector<int32_t> radii;
  for (int32_t r = 1; r < last; r += r < kUnitRadii ? 1 : (r < 2 * kUnitRadii ? 2 : 4)) radii.push_back(r);
  radii.push_back(last);
  return radii;
}

// Of pits that are steeper than any surface nothing is left (low outliers; section 2.1).
void DropPits(double drop, StepRaster& raster) {
  StepRaster upside_down = raster;
  for (int16_t& h : upside_down.heights) h = h == kNoSurface ? kNoSurface : static_cast<int16_t>(-h);
  const StepRaster opened = OpenedByDisk(upside_down, 1);
  for (size_t i = 0; i < raster.heights.size(); ++i) {
    if (raster.heights[i] == kNoSurface) continue;
    if (upside_down.heights[i] - opened.heights[i] > drop) raster.heights[i] = kNoSurface;
  }
}

// How far ground is looked for, metres.
double SightOver(double square) { return std::max(kGroundSight, kMinSight * square); }

// The smaller rise to either side; where one side has no ground, that of the other.
float RiseBeside(float before, float here, float behind) {
  const float a = std::abs(here - before), b = std::abs(behind - here);
  if (std::isnan(a)) return std::isnan(b) ? 0 : b;
  return std::isnan(b) ? a : std::min(a, b);
}

}  // namespace

FilteredGround::FilteredGround(GroundRaster lowest, const GroundFilterOptions& options)
    : options_(options), ground_(std::move(lowest)) {
  DropObjects(SquareBlocks::All(ground_.cols, ground_.rows));
}

FilteredGround::FilteredGround(GroundRaster lowest, const GroundFilterOptions& options, const SquareBlocks& asked)
    : options_(options), ground_(std::move(lowest)) {
  DropObjects(asked);
}

void FilteredGround::DropObjects(const SquareBlocks& asked) {
  const SquareBlocks seen = asked.GrownBy(static_cast<int32_t>(SightOver(ground_.square) / ground_.square) + 1);
  const Steps steps(ground_.heights);
  StepRaster surface = InSteps(ground_, steps);
  DropPits(options_.outlier_slope * ground_.square / steps.step, surface);
  std::vector<OpeningStep> openings;
  for (const int32_t radius : Radii(options_.window, ground_.square)) {
    openings.push_back({radius, options_.slope * radius * ground_.square / steps.step});
  }
  const std::vector<uint8_t> is_object = ObjectSquares(surface, seen, openings);
  for (size_t i = 0; i < surface.heights.size(); ++i) {
    if (surface.heights[i] == kNoSurface || is_object[i] != 0) ground_.heights[i] = kNone;
  }
}

float FilteredGround::At(const GroundRaster& raster, int32_t col, int32_t row) {
  return raster.Contains(col, row) ? raster.heights[raster.IndexOf(col, row)] : kNone;
}

FilteredGround::Place FilteredGround::GroundAt(int32_t col, int32_t row) const {
  const float height = At(ground_, col, row);
  if (std::isnan(height)) return UnderObject(col, row);
  Mean here;
  here.Add(height, SlopeOfGround(col, row), 1);
  Place place = WithTolerance(here);
  place.is_between = true;
  return place;
}

FilteredGround::Place FilteredGround::WithTolerance(const Mean& mean) const {
  if (mean.weights == 0) return {kNone, 0};
  return {static_cast<float>(mean.heights / mean.weights),
          static_cast<float>(options_.threshold + options_.slope_factor * mean.slopes / mean.weights)};
}

float FilteredGround::SlopeOfGround(int32_t col, int32_t row) const {
  const float here = At(ground_, col, row);
  const float rise_x = RiseBeside(At(ground_, col - 1, row), here, At(ground_, col + 1, row));
  const float rise_y = RiseBeside(At(ground_, col, row - 1), here, At(ground_, col, row + 1));
  return std::hypot(rise_x, rise_y) / static_cast<float>(ground_.square);
}

FilteredGround::Place FilteredGround::UnderObject(int32_t col, int32_t row) const {
  constexpr int kDirections[8][2] = {{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}};
  Mean between, beyond;
  for (const auto& [dx, dy] : kDirections) {
    const Sight before = Look(col, row, -dx, -dy), behind = Look(col, row, dx, dy);
    const double way = before.distance + behind.distance;
    if (!std::isnan(way)) {
      between.Add((behind.distance * before.height + before.distance * behind.height) / way,
                  std::abs(behind.height - before.height) / way, way);
    }
    for (const Sight& sight : {before, behind}) {
      if (std::isnan(sight.height) || std::isnan(sight.farther)) continue;
      beyond.Add(2 * sight.height - sight.farther, std::abs(sight.height - sight.farther) / sight.distance,
                 sight.distance);
    }
  }
  Place place = between.weights > 0 ? WithTolerance(between) : WithTolerance(beyond);
  place.is_between = between.weights > 0;
  return place;
}

// The first ground in a direction, and the ground twice as far off.
FilteredGround::Sight FilteredGround::Look(int32_t col, int32_t row, int32_t dx, int32_t dy) const {
  const double step = std::hypot(dx, dy) * ground_.square;
  const double sight = SightOver(ground_.square);
  for (int32_t k = 1; k * step <= sight; ++k) {
    const float height = At(ground_, col + k * dx, row + k * dy);
    if (std::isnan(height)) continue;
    return {k * step, height, 2 * k * step <= sight ? At(ground_, col + 2 * k * dx, row + 2 * k * dy) : kNone};
  }
  return {};
}

}  // namespace tilemend
