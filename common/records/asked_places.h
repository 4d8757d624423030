// Places of a cluster, besides its boundary, where its surface is asked for.
#ifndef TILEMEND_COMMON_RECORDS_ASKED_PLACES_H_
#define TILEMEND_COMMON_RECORDS_ASKED_PLACES_H_

#include <cstdint>
#include <vector>

#include "common/records/cell_holes.h"

namespace tilemend {

// The vertices that no segment of a hole has, ascending. O(vertices and segments).
std::vector<int32_t> VerticesWithoutSegment(const CellHoles& holes);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_ASKED_PLACES_H_
