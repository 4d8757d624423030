// A small plan that is made by hand.
#ifndef TILEMEND_TESTS_COORDINATOR_WAVES_MADE_PLAN_H_
#define TILEMEND_TESTS_COORDINATOR_WAVES_MADE_PLAN_H_

#include <cstdint>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

inline PlannedHole HoleIn(CellId cell, int32_t cluster, int32_t layer = 1) {
  PlannedHole hole;
  hole.cell = cell;
  hole.cluster = cluster;
  hole.layer = layer;
  hole.segments.resize(3);
  return hole;
}

// A cluster over two cells, a closed hole beside it, another cluster, and a hole that cannot be filled.
inline Plan MadePlan() {
  Plan plan;
  plan.holes = {HoleIn({0, 0}, 0), HoleIn({1, 0}, 0, 2), HoleIn({1, 0}, -1), HoleIn({2, 0}, 1), HoleIn({0, 0}, 2)};
  plan.holes[4].failure = "no";
  return plan;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COORDINATOR_WAVES_MADE_PLAN_H_
