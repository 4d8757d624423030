// The shore of a hole that may be water: its rim vertices in order, and the ground beside them.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_SHORE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_SHORE_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

inline constexpr size_t kLeastShore = 24;  // rim vertices: fewer tell too little
inline constexpr size_t kLongShore = 96;   // rim vertices: shorter ones need a bank that rises

// The original vertices (into Plan::vertices) on the rims of the holes, in order along them, rim after rim. Cost O(n
// log n) in the holes' segments.
std::vector<int32_t> ShoreOf(const Plan& plan, const std::vector<int32_t>& holes);

struct ShoreGround {
  std::vector<double> bank;  // for each shore vertex: mean height one edge landward; NaN if all there is shore
  // Standard deviation of the heights, metres: of noise, and of what is as rough as noise. From how far each pair of
  // neighbouring triangles at the shore is from a plane, in the median; at the lowest quarter of the shore vertices
  // alone if that is more, as water is noisier than ground. Pairs that rise by more than a metre are walls. 0 where
  // there is no other pair.
  double noise = 0;
};

// What the survey's bands tell of each shore; a vertex on two shores counts for the first. Cost O(n log n) in the
// bands' triangles and the plan's vertices.
std::vector<ShoreGround> FindGround(const Plan& plan, const PlanInput& input,
                                    std::span<const std::vector<int32_t>> shores);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_SHORE_H_
