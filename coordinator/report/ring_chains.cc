#include "coordinator/report/ring_chains.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "common/mesh/plane_polygon.h"

namespace tilemend {
namespace {

double SignedArea(const std::vector<Point2>& ring) {
  double twice = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

}  // namespace

std::vector<std::vector<int32_t>> RingsOf(const std::vector<RimSegment>& segments) {
  std::multiset<std::pair<int32_t, int32_t>> walks;
  for (const RimSegment& s : segments) {
    if (const auto back = walks.find({s.to, s.from}); back != walks.end()) {
      walks.erase(back);
    } else {
      walks.insert({s.from, s.to});
    }
  }
  std::vector<std::vector<int32_t>> rings;
  while (!walks.empty()) {
    std::vector<int32_t> walk = {walks.begin()->first};
    std::map<int32_t, size_t> place = {{walk[0], 0}};
    for (auto step = walks.begin(); step != walks.end(); step = walks.lower_bound({walk.back(), INT32_MIN})) {
      if (step->first != walk.back()) break;
      const int32_t to = step->second;
      walks.erase(step);
      const auto [seen, fresh] = place.try_emplace(to, walk.size());
      if (fresh) {
        walk.push_back(to);
        continue;
      }
      // A ring is closed wherever the walk meets itself, so that rings that touch at a vertex are two.
      rings.emplace_back(walk.begin() + static_cast<ptrdiff_t>(seen->second), walk.end());
      for (size_t i = seen->second + 1; i < walk.size(); ++i) place.erase(walk[i]);
      walk.resize(seen->second + 1);
    }
  }
  return rings;
}

std::vector<RingPolygon> PolygonsOf(const std::vector<std::vector<Point2>>& rings) {
  std::vector<double> areas;
  for (const auto& ring : rings) areas.push_back(SignedArea(ring));
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest = std::max_element(areas.begin(), areas.end(), larger);
  std::vector<RingPolygon> polygons;
  for (size_t i = 0; i < rings.size(); ++i) {
    if (areas[i] * *largest > 0 || areas[i] == *largest) polygons.push_back({static_cast<int32_t>(i), {}});
  }
  std::sort(polygons.begin(), polygons.end(), [&](const RingPolygon& a, const RingPolygon& b) {
    return std::abs(areas[a.outline]) < std::abs(areas[b.outline]);
  });
  for (size_t i = 0; i < rings.size(); ++i) {
    if (areas[i] * *largest > 0 || areas[i] == *largest) continue;
    const Point2 between = (rings[i][0] + rings[i][1]) / 2;  // rings may touch at their points
    const auto around = std::find_if(polygons.begin(), polygons.end(), [&](const RingPolygon& polygon) {
      return Contains({{rings[polygon.outline]}}, between);
    });
    if (around != polygons.end()) around->islands.push_back(static_cast<int32_t>(i));
  }
  return polygons;
}

}  // namespace tilemend
