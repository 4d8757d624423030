// The ground at rims among objects that the surface of a hole goes by.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_GROUND_POINTS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_GROUND_POINTS_H_

#include <vector>

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/known_objects.h"

namespace tilemend {

// What the surface of a group of holes (GroupHoles) is linear between: the original vertices of its rim that stand on
// no object, each as high as the lowest of them within 2 m, since what is narrower than that is a car, a hedge, a kerb;
// and the platforms that objects stand on (FindPlatforms). Of points over one place the first counts: that of the
// lowest platform there, if there is one.
std::vector<Point3> GroundOfShore(const Plan& plan, const std::vector<int32_t>& holes);

// Sets PlannedHole::ground_points of the holes among objects. The surface of their group is linear between
// GroundOfShore by its Delaunay triangulation. A hole gets the corners of the triangles that meet its extent:
// triangulated again, they give the same surface there, so that it does not depend on where the grid cuts. Holes that
// are parts of known shores go by the ground of these alone, whatever the area leaves of them; others of their group by
// that and by their own. Cost for each group O(n log n) in its rim, and the triangles that meet each hole.
void FindGroundPoints(const KnownObjects& known, Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_GROUND_POINTS_H_
