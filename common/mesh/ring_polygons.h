// Rings as polygons: outlines, each with the outlines of its islands.
#ifndef TILEMEND_COMMON_MESH_RING_POLYGONS_H_
#define TILEMEND_COMMON_MESH_RING_POLYGONS_H_

#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// An outline and the outlines of its islands, into the rings that were given.
struct RingPolygon {
  int32_t outline = -1;
  std::vector<int32_t> islands;  // rising
};

// Puts rings together by the even-odd rule, in any direction. A ring that lies within an even number of others is an
// outline. Each other one belongs to the smallest outline around it. Polygons come by the area of their outline, the
// smallest first. Precondition: rings do not cross, and touch in single points at most. Cost O(rings * vertices).
std::vector<RingPolygon> PolygonsOf(const std::vector<std::vector<Point2>>& rings);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_RING_POLYGONS_H_
