// The holes of a plan by the cells that they are filled in.
#ifndef TILEMEND_COORDINATOR_WAVES_HOLES_OF_CELLS_H_
#define TILEMEND_COORDINATOR_WAVES_HOLES_OF_CELLS_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Numbers of holes are those of Plan::holes.
//
// By cell, the holes that the plan finds no fault with. Of cells that are not chosen those whose clusters reach chosen
// ones, and no cell without any. No chosen cells: all are.
std::map<CellId, std::vector<int32_t>> HolesToFill(const Plan& plan, const std::set<CellId>& chosen);

std::set<CellId> CellsOf(const Plan& plan, const std::vector<int32_t>& holes);

// For each cluster the cells whose fill needs its heights. They are those of its own holes, and those whose patches
// have a new vertex of its boundary. A tile that overlaps its neighbour may have one though no hole of the cluster lies
// in its cell.
//   holes_of           by cell, the holes to fill
//   holes_of_clusters  by cluster
// Cost O(n log n) in the holes' segments.
std::map<int32_t, std::set<CellId>> CellsThatAwait(const Plan& plan,
                                                   const std::map<CellId, std::vector<int32_t>>& holes_of,
                                                   const std::map<int32_t, std::vector<int32_t>>& holes_of_clusters);

// How many segments their boundaries have.
size_t SegmentsOf(const Plan& plan, const std::vector<int32_t>& holes);

// The last layer of those that are no water; 1 where there is none.
int32_t LastLayerOf(const Plan& plan, const std::vector<int32_t>& holes);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_HOLES_OF_CELLS_H_
