// Numbers of the plan, as far as one task knows of them.
#ifndef TILEMEND_COORDINATOR_WAVES_LOCAL_NUMBERS_H_
#define TILEMEND_COORDINATOR_WAVES_LOCAL_NUMBERS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "common/records/cell_holes.h"

namespace tilemend {

// The plan numbers holes and vertices through the whole scene. So one more hole in a cell shifts the numbers in all
// cells that come after it. A task that numbers its own from 0 is the same task for both plans, and so is its result.
struct LocalNumbers {
  std::vector<int32_t> holes;          // of the plan, in ascending order: local number i stands for holes[i]
  std::vector<int32_t> seam_vertices;  // likewise
};

// Replaces the plan's numbers in `holes` by local ones, whose order is the same.
LocalNumbers Localise(CellHoles& holes);
// The same numbers in both.
LocalNumbers Localise(CellHoles& holes, CellHoles& others);

// What the plan calls a local number; none if that is out of range.
std::optional<int32_t> InPlan(const std::vector<int32_t>& numbers, int64_t local);
// The local number of one that is there.
int32_t LocalNumber(const std::vector<int32_t>& numbers, int32_t in_plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_LOCAL_NUMBERS_H_
