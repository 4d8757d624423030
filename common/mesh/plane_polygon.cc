#include "common/mesh/plane_polygon.h"

#include <cmath>

namespace tilemend {

bool Contains(const PlanePolygon& polygon, const Point2& p) {
  bool inside = false;
  for (const std::vector<Point2>& ring : polygon.rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
      inside ^= p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    }
  }
  return inside;
}

double AreaOf(const PlanePolygon& polygon) {
  double area = 0;
  for (size_t r = 0; r < polygon.rings.size(); ++r) {
    const std::vector<Point2>& ring = polygon.rings[r];
    double twice = 0;
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    bool is_hole = false;  // within an odd number of others
    for (size_t other = 0; other < polygon.rings.size(); ++other) {
      is_hole ^= other != r && Contains({{polygon.rings[other]}}, ring[0]);
    }
    area += (is_hole ? -0.5 : 0.5) * std::abs(twice);
  }
  return area;
}

}  // namespace tilemend
