// Which chains of a tile's boundary, and which gaps between them, bound which holes.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_CHAIN_GROUPS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_CHAIN_GROUPS_H_

#include <cstdint>
#include <vector>

#include "common/records/survey_record.h"
#include "coordinator/plan/overlap/outline_walk.h"

namespace tilemend {

// What closes together.
struct ChainGroup {
  std::vector<size_t> holes;   // ascending, at least one
  std::vector<int32_t> edges;  // into SurveyRecord::edges
  std::vector<OutlineGap> gaps;
};

// Groups chains of edges, the gaps that they end at, and the holes that they bound. Chains that meet in a vertex stay
// apart, unless one of them does not close without the others there, or bounds no hole.
//   is_chain       of each edge: whether it counts
//   gaps           between ends of chains
//   edges_of_hole  of each hole: edges that are known to bound it
// In order of the first hole. Cost O(n log n) in the edges, times the rounds of chains that hold each other together.
std::vector<ChainGroup> GroupChains(const SurveyRecord& record, const std::vector<bool>& is_chain,
                                    const std::vector<OutlineGap>& gaps,
                                    const std::vector<std::vector<int32_t>>& edges_of_hole);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_CHAIN_GROUPS_H_
