// A square of triangles whose inner points lie about without order: what is renumbered and smoothed.
#ifndef TILEMEND_TESTS_WORKER_FILL_REGION_SCATTERED_REGION_H_
#define TILEMEND_TESTS_WORKER_FILL_REGION_SCATTERED_REGION_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "common/mesh/triangulation/delaunay.h"
#include "tests/worker/fill/region/refine_quality.h"

namespace tilemend::testing {

struct ScatteredRegion {
  internal::RegionMesh region;
  std::vector<RegionSegment> segments;
  std::vector<double> size;  // per point
  size_t first = 0;          // inner point

  internal::DelaunayMesh& mesh() { return region.mesh; }
  const internal::DelaunayMesh& mesh() const { return region.mesh; }
  std::vector<LatticePoint> Points() const {
    std::vector<LatticePoint> points;
    for (const internal::Point32 p : mesh().points) points.push_back(internal::Widen(p));
    return points;
  }
};

// The rim comes first, then one point in each inner unit square, in an order that `order` shuffles. Its place in its
// square follows from `where`.
inline ScatteredRegion Scattered(int side, uint32_t where, uint32_t order) {
  constexpr int64_t kSpacing = 1000;
  SizedRegion square = GridSquare(side, kSpacing);
  ScatteredRegion result;
  result.first = square.points.size();
  result.segments = square.segments;
  std::mt19937 places(where);
  std::uniform_int_distribution<int64_t> within(100, kSpacing - 100);
  for (int64_t row = 0; row < side; ++row) {
    for (int64_t column = 0; column < side; ++column) {
      const int64_t x = column * kSpacing + within(places);
      square.points.push_back({x, row * kSpacing + within(places)});
    }
  }
  std::shuffle(square.points.begin() + static_cast<std::ptrdiff_t>(result.first), square.points.end(),
               std::mt19937(order));
  result.region = internal::BuildRegionMesh(square.points, square.segments);
  result.size.assign(square.points.size(), static_cast<double>(kSpacing));
  return result;
}

}  // namespace tilemend::testing

#endif  // TILEMEND_TESTS_WORKER_FILL_REGION_SCATTERED_REGION_H_
