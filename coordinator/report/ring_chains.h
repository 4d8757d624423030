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

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_RING_CHAINS_H_
