// Marks the rim vertices that stand on objects, and the holes in the ground.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_MARK_OBJECTS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_MARK_OBJECTS_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Leaves PlanVertex::on_object and PlanVertex::ground to the original vertices on the rims of open clusters, and of
// closed holes that face up. If all vertices of such a rim stand on objects, none keeps them. A hole in a roof or a
// crown is filled as these go on. Nor do those of a part that objects shut off (hole_parts.h). Lowers the sizes of
// vertices on objects to the lengths of their edges seen from above. Sets PlannedHole::in_ground of those closed holes
// most of whose original vertices lie on the ground. Cost O(n log n) in the holes' segments.
void MarkObjects(Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_MARK_OBJECTS_H_
