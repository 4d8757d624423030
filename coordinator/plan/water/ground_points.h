// The ground at rims among objects that the surface of a hole goes by.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_GROUND_POINTS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_GROUND_POINTS_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Sets PlannedHole::ground_points of the holes among objects. The surface of their group (GroupHoles) is linear between
// the original vertices of its rim that stand on no object, by their Delaunay triangulation; each counts as high as the
// lowest of them within 2 m, since what is narrower than that is a car, a hedge, a kerb. A hole gets the corners of the
// triangles that meet its extent: triangulated again, they give the same surface there, so that it does not depend on
// where the grid cuts. Cost for each group O(n log n) in its rim, and the triangles that meet each hole.
void FindGroundPoints(Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_GROUND_POINTS_H_
