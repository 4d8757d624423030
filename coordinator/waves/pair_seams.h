// The seams that the surface of Wang 2021 smooths.
#ifndef TILEMEND_COORDINATOR_WAVES_PAIR_SEAMS_H_
#define TILEMEND_COORDINATOR_WAVES_PAIR_SEAMS_H_

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "coordinator/plan/seam/seam_heights.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

using CellPair = std::pair<CellId, CellId>;  // the lower one first

// What two cells have in common. Numbers of the plan.
struct PairSeam {
  std::set<int32_t> holes_of_first, holes_of_second;
  std::set<int32_t> vertices;  // of seams, with a height
  int32_t number = 0;          // of those whose first cell is the same; cells across a corner have one too
};

// The seams between holes of one layer in two cells (Wang 2021, 3.4). `holes` are those that were filled; water and
// closed ones have none. O(n log n) in their segments.
std::map<CellPair, PairSeam> FindPairSeams(const Plan& plan, std::span<const int32_t> holes,
                                           const SeamHeights& heights);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_PAIR_SEAMS_H_
