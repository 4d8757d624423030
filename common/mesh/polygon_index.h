// Point-in-polygon tests against one polygon, many times.
#ifndef TILEMEND_COMMON_MESH_POLYGON_INDEX_H_
#define TILEMEND_COMMON_MESH_POLYGON_INDEX_H_

#include <utility>
#include <vector>

#include "common/mesh/plane_polygon.h"

namespace tilemend {

// The edges of a polygon in horizontal bands. Immutable after construction, so any number of threads may ask.
class PolygonIndex {
 public:
  // Cost O(n sqrt(n)) for n points at most, O(n) where edges are short.
  explicit PolygonIndex(const PlanePolygon& polygon);

  // The same answer as Contains(polygon, p), to the bit. Cost O(sqrt(n)) where edges spread evenly.
  bool Contains(const Point2& p) const;
  // Bounds of the polygon; low > high for an empty one.
  const Point2& lo() const { return lo_; }
  const Point2& hi() const { return hi_; }

 private:
  size_t BandOf(double y) const;

  Point2 lo_, hi_;
  double band_height_ = 1;
  std::vector<std::vector<std::pair<Point2, Point2>>> bands_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_POLYGON_INDEX_H_
