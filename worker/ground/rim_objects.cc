#include "worker/ground/rim_objects.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "worker/ground/join_rasters.h"
#include "worker/ground/surroundings.h"

namespace tilemend {
namespace {

// The squares that the filter looks at, as far as there are rasters.
GroundRaster Frame(std::span<const Point3> vertices, std::span<const GroundRaster> rasters, double square,
                   double reach) {
  Eigen::Array2i low = Eigen::Array2i::Constant(INT32_MAX), high = Eigen::Array2i::Constant(INT32_MIN), lo = low,
                 hi = high;
  for (const Point3& v : vertices) {
    const Eigen::Array2i at(SquareAt(v.x(), square), SquareAt(v.y(), square));
    low = low.min(at);
    high = high.max(at);
  }
  for (const GroundRaster& r : rasters) {
    if (r.empty()) continue;
    lo = lo.min(Eigen::Array2i(r.col, r.row));
    hi = hi.max(Eigen::Array2i(r.col + r.cols - 1, r.row + r.rows - 1));
  }
  const auto more = static_cast<int32_t>(std::ceil(reach / square)) + 5;
  if ((low > high).any() || (lo > hi).any()) return {};
  low = (low - more).max(lo);
  high = (high + more).min(hi);
  if ((low > high).any()) return {};
  return EmptyRaster(square, low.x(), low.y(), high.x() - low.x() + 1, high.y() - low.y() + 1);
}

}  // namespace

RimGround GroundAtRim(std::span<const Point3> vertices, std::span<const GroundRaster> rasters,
                      const GroundFilterOptions& options) {
  RimGround result{std::vector<bool>(vertices.size(), false),
                   std::vector<float>(vertices.size(), std::numeric_limits<float>::quiet_NaN())};
  if (vertices.empty() || rasters.empty()) return result;
  const double square = rasters[0].square;
  GroundRaster lowest = Frame(vertices, rasters, square, FilterReach(options));
  for (const GroundRaster& r : rasters) LowerTo(r, lowest);
  if (lowest.empty()) return result;
  SquareBlocks asked(lowest.cols, lowest.rows), rims = asked;
  for (const Point3& v : vertices) {
    const int32_t col = SquareAt(v.x(), square), row = SquareAt(v.y(), square);
    if (!lowest.Contains(col, row)) continue;
    asked.Add(col - lowest.col, row - lowest.row);
    if (IsBesideHole(lowest, col, row)) rims.Add(col - lowest.col, row - lowest.row);
  }
  const SquareBlocks surroundings = SurroundingsOf(rims, square);
  asked.AddAll(surroundings);
  const FilteredGround filtered(lowest, options, asked);
  result.side = kSquaresAlongSide * square;
  result.around = GroundIn(surroundings, lowest, filtered);
  for (size_t v = 0; v < vertices.size(); ++v) {
    const int32_t col = SquareAt(vertices[v].x(), square), row = SquareAt(vertices[v].y(), square);
    if (!lowest.Contains(col, row) || std::isnan(lowest.heights[lowest.IndexOf(col, row)])) continue;
    const FilteredGround::Place place = filtered.GroundAt(col, row);
    if (place.is_between) result.ground[v] = place.height;
    result.on_object[v] = !(std::abs(vertices[v].z() - place.height) <= place.tolerance);
  }
  return result;
}

}  // namespace tilemend
