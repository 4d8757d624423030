// Marks the rim vertices that stand on objects.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_MARK_OBJECTS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_MARK_OBJECTS_H_

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/known_objects.h"

namespace tilemend {

// Sets PlanVertex::on_object of the original vertices on the rims of open clusters, and of closed holes that face up
// and project, if they are at least 20 m across, where the way down is steeper than ground (StepsDown, with the bands
// of the cells around as surroundings) or where walls lift them (OnRaisedLevels), provided that the steps at all these
// rims together are walls (AreWalls), or something is known to stand at the rims of the scene. Smaller holes are filled
// as the surface around them goes on, walls and roofs included. Where all of a rim would stand on objects, none of it
// does. What is known of vertices stays so. A group of which every hole is a part of a known shore is among objects
// where that is, and where no vertex of its rim is known to be ground. Lowers the sizes of such vertices to the lengths
// of their edges seen from above. Cost near-linear in the bands of the cells that such holes reach, for each hole.
void MarkObjects(const PlanInput& input, const KnownObjects& known, Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_MARK_OBJECTS_H_
