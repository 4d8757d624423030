// Segments of a boundary that are there both ways.
#ifndef TILEMEND_COORDINATOR_PLAN_TYPES_DOUBLED_SEGMENTS_H_
#define TILEMEND_COORDINATOR_PLAN_TYPES_DOUBLED_SEGMENTS_H_

#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "common/records/cell_holes.h"

namespace tilemend {

// Takes out the segments of which the same edge is there the other way as well: nothing lies between. So it is where a
// seam or a link runs back along an edge. The others keep their order. `segment_of` gives the RimSegment of an item.
// Cost O(n log n).
template <typename Item, typename SegmentOf = std::identity>
void DropDoubled(std::vector<Item>& items, SegmentOf segment_of = {}) {
  std::set<std::pair<int32_t, int32_t>> directed;
  for (const Item& item : items) {
    const auto& segment = std::invoke(segment_of, item);
    directed.insert({segment.from, segment.to});
  }
  std::erase_if(items, [&](const Item& item) {
    const auto& segment = std::invoke(segment_of, item);
    return directed.contains({segment.to, segment.from});
  });
}

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_TYPES_DOUBLED_SEGMENTS_H_
