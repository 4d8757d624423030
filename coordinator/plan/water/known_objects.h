// What stands at the water of the whole scene, where an area takes only a part of it.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_KNOWN_OBJECTS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_KNOWN_OBJECTS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// The rim of a group of holes (GroupHoles) that are no water.
struct KnownShore {
  bool among_objects = false;  // as PlannedHole::among_objects
  std::vector<Point3> ground;  // GroundOfShore
};

struct KnownObjects {
  bool any = false;                            // something stands at some rim of the scene
  std::vector<std::optional<bool>> on_object;  // by vertex of the plan; none: it is on no rim of the scene
  std::vector<KnownShore> shores;
  std::vector<int32_t> shore_of;  // by hole of the plan: the shore of what it is a part of; -1: of none

  // The shore of the first of the holes of which one is known; else null.
  const KnownShore* ShoreOf(const std::vector<int32_t>& holes) const;
  // Forgets what is known of some holes of the plan, ascending, and of vertices that are on their rims alone.
  void Forget(const Plan& plan, const std::vector<int32_t>& holes);
};

// Finds what the objects of `whole`, a plan of the same records and grid without the area, say of `plan`. Cost linear
// in the vertices of both, and that of GroupsCovering.
KnownObjects FindKnownObjects(const Plan& whole, const Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_KNOWN_OBJECTS_H_
