// Outlines that cross: bow-ties, and outlines of parts that overlap.
#ifndef TILEMEND_COMMON_MESH_OUTLINE_CROSSING_H_
#define TILEMEND_COMMON_MESH_OUTLINE_CROSSING_H_

#include <cstddef>
#include <optional>
#include <string>

#include "common/mesh/plane_polygon.h"

namespace tilemend {

// Where two edges cross; each edge begins at a point of a ring.
struct OutlineCrossing {
  struct Edge {
    size_t ring = 0, point = 0;
  };
  Edge first, second;
  Point2 at{0, 0};
};

// The first crossing, by x, of two edges of the polygon. None if they only touch, or pass each other by at most 1e-9 of
// the coordinates' size, which is what transformations leave. Cost O(n log n + pairs of edges that share an x).
std::optional<OutlineCrossing> FindCrossing(const PlanePolygon& polygon);

// For people: "ring 0 crosses itself at (3, 4), where the edges from positions 1 and 3 meet".
std::string TextOf(const OutlineCrossing& crossing);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_OUTLINE_CROSSING_H_
