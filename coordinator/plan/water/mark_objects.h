// Marks the rim vertices that stand on objects, and the holes in the ground.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_MARK_OBJECTS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_MARK_OBJECTS_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Leaves PlanVertex::on_object and PlanVertex::ground to the original vertices on the rims of open clusters, and of
// closed holes that face up. If all vertices of such a rim stand on objects, none keeps them: a hole in a roof or a
// crown is filled as these go on. Nor do those that the part of a hole in a roof joins (hole_parts.h). Where such a
// part passes above the rim, on_object is set, and ground is the height of the fill there. A vertex on several rims
// stands on an object if it does for one of them. Lowers the sizes of vertices on objects to the lengths of their edges
// seen from above. Sets PlannedHole::standing of those closed holes that have an original vertex on the ground. Cost
// O(n log n) in the holes' segments, and that of FindRoofParts.
void MarkObjects(Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_MARK_OBJECTS_H_
