// The order in which points go into an incremental triangulation.
#ifndef TILEMEND_COMMON_MESH_TRIANGULATION_INSERTION_ORDER_H_
#define TILEMEND_COMMON_MESH_TRIANGULATION_INSERTION_ORDER_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/predicates.h"

namespace tilemend::internal {

// Sorts `indices` (into points) into a biased randomized insertion order (Amenta, Choi, Rote 2003): rounds that double
// in size, each along a Hilbert curve. The coin is a hash of the place in the list, so the order is the same every
// time.
void SortForInsertion(std::span<const Point32> points, std::vector<int32_t>& indices);

// Sorts `indices` along one Hilbert curve: points that are near each other come near each other in the list.
void SortAlongCurve(std::span<const Point32> points, std::vector<int32_t>& indices);

}  // namespace tilemend::internal

#endif  // TILEMEND_COMMON_MESH_TRIANGULATION_INSERTION_ORDER_H_
