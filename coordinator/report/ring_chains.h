// The rings that the segments of holes form.
#ifndef TILEMEND_COORDINATOR_REPORT_RING_CHAINS_H_
#define TILEMEND_COORDINATOR_REPORT_RING_CHAINS_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Closed walks, not repeating the first vertex. Segments that run both ways between two vertices, as seams do between
// two holes, bound nothing and are left out. A walk that ends nowhere is left out too. Cost O(n log n).
std::vector<std::vector<int32_t>> RingsOf(const std::vector<RimSegment>& segments);

// An outline and the outlines of its islands, into the rings that were given.
struct RingPolygon {
  int32_t outline = -1;
  std::vector<int32_t> islands;
};

// Puts rings together, seen from above. Those that turn as the largest one does are outlines; each other one belongs to
// the smallest outline around it. Cost O(outlines * vertices).
std::vector<RingPolygon> PolygonsOf(const std::vector<std::vector<Point2>>& rings);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_RING_CHAINS_H_
