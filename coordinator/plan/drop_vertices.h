// What a plan needs to remember of the rim once it is made.
#ifndef TILEMEND_COORDINATOR_PLAN_DROP_VERTICES_H_
#define TILEMEND_COORDINATOR_PLAN_DROP_VERTICES_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Drops the vertices that bound no hole and lie on no seam. They lie along the rim of the area, of detached pieces and
// of tiles that nothing is filled beside. The others keep their order. Linear in the plan.
void DropUnusedVertices(Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_DROP_VERTICES_H_
