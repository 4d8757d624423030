#include "common/mesh/ring_polygons.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "common/mesh/plane_polygon.h"

namespace tilemend {
namespace {

double AbsoluteArea(const std::vector<Point2>& ring) {
  double twice = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(twice) / 2;
}

}  // namespace

std::vector<RingPolygon> PolygonsOf(const std::vector<std::vector<Point2>>& rings) {
  std::vector<double> areas;
  std::vector<Eigen::AlignedBox2d> boxes(rings.size());
  for (size_t i = 0; i < rings.size(); ++i) {
    areas.push_back(AbsoluteArea(rings[i]));
    for (const Point2& p : rings[i]) boxes[i].extend(p);
  }
  std::vector<int32_t> rising(rings.size());
  std::iota(rising.begin(), rising.end(), 0);
  std::ranges::stable_sort(rising, {}, [&](int32_t i) { return areas[i]; });
  // The ring around each, if it is the outline of an island: that within an odd number of others.
  std::vector<int32_t> around(rings.size(), -1);
  for (size_t i = 0; i < rising.size(); ++i) {
    const std::vector<Point2>& ring = rings[rising[i]];
    const Point2 between = (ring[0] + ring[1]) / 2;  // rings may touch at their points
    std::vector<int32_t> outer;
    for (const int32_t other : rising) {
      if (other == rising[i] || !boxes[other].contains(between)) continue;
      if (Contains({{rings[other]}}, between)) outer.push_back(other);
    }
    if (outer.size() % 2 == 1) around[rising[i]] = outer.front();
  }
  std::vector<RingPolygon> polygons;
  std::vector<int32_t> polygon_of(rings.size(), -1);
  for (const int32_t i : rising) {
    if (around[i] >= 0) continue;
    polygon_of[i] = static_cast<int32_t>(polygons.size());
    polygons.push_back({i, {}});
  }
  for (size_t i = 0; i < rings.size(); ++i) {
    if (around[i] >= 0) polygons[polygon_of[around[i]]].islands.push_back(static_cast<int32_t>(i));
  }
  return polygons;
}

}  // namespace tilemend
