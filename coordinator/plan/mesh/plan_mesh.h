// Plans the holes of one mesh that has no grid and may lie in any way.
#ifndef TILEMEND_COORDINATOR_PLAN_MESH_PLAN_MESH_H_
#define TILEMEND_COORDINATOR_PLAN_MESH_PLAN_MESH_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Every boundary loop of the mesh becomes part of a hole, an outline (outlines.h), or stays open for a reason. Chains
// of boundary edges that form no loop are left for a reason as well. Nothing depends on the mesh's size or on how it is
// turned. New vertices lie on a lattice that is fine beside the edges of the holes. With water (options.water) z is up,
// and holes of heights are marked as such.
//
// Preconditions: !input.has_grid, one cell with a record. Cost O(n log n) in the boundary edges, see loop_groups.h.
Plan PlanMesh(const PlanInput& input, const PlanOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_MESH_PLAN_MESH_H_
