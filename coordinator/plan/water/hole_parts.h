// Parts of a hole that objects shut off from the rest of it.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_HOLE_PARTS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_HOLE_PARTS_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct ShutOff {
  std::vector<int32_t> on_object;                // the surface goes through them
  std::vector<std::pair<int32_t, float>> below;  // it does not, and its height there, metres
};

// Where a roof is open together with the street beside it, the hole goes through a gap in the facade. Seen from above
// it then has two parts, which a narrow neck between objects joins. Like a hole whose whole rim stands on objects, such
// a part is filled as the object goes on.
//
// The neck is closed by taking squares of 1.5 m around the rim's objects from the region; what is left falls apart. A
// part counts if walls between its rim and the level of its objects (the median) are less than half of the walls
// between the rim and the ground. Rims steeper than 45 degrees do not count.
// docs/decisions/2026-11-29-parts-of-holes.md has the experiments.
//
// Returns the original vertices on the rims of these parts, in no order. Those nearer to the ground than to the level
// are below.
//
//   holes  a group of GroupHoles
//
// Cost O(n log n) in the rim's segments and the lines, 0.25 m apart, that they cross.
ShutOff VerticesShutOff(const Plan& plan, const std::vector<int32_t>& holes);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_HOLE_PARTS_H_
