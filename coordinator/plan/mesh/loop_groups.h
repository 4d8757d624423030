// Which boundary loops of a mesh bound one hole together.
#ifndef TILEMEND_COORDINATOR_PLAN_MESH_LOOP_GROUPS_H_
#define TILEMEND_COORDINATOR_PLAN_MESH_LOOP_GROUPS_H_

#include <span>
#include <vector>

#include "coordinator/plan/mesh/loop_kinds.h"
#include "coordinator/plan/mesh/mesh_loops.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct MeshHole {
  size_t loop = 0;             // the outer one
  std::vector<size_t> others;  // outlines of islands, or the other end of a ring
  SingleType single = SingleType::kSimple;
};

struct LoopGroups {
  std::vector<MeshHole> holes;   // by outer loop
  std::vector<size_t> outlines;  // that bound no hole
};

// Groups loops into holes. Loops that face each other are annular holes; outlines of pieces are islands of the smallest
// hole that they lie in. Each hole is classified in the paper's order: crack, dislocation, annular, island, simple
// (Zhang 2022, 4.2). An outline that faces another loop is none. O(n^2) in loops whose boxes are near, O(n log n) in
// all else.
LoopGroups GroupLoops(const Rim& rim, std::span<const MeshLoop> loops, const std::vector<bool>& is_outline,
                      const DislocationLimit& dislocation = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_MESH_LOOP_GROUPS_H_
