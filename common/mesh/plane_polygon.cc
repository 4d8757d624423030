#include "common/mesh/plane_polygon.h"

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

}  // namespace tilemend
