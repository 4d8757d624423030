// Parts of a hole that lie in a roof, where the rest of it lies in the ground.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_HOLE_PARTS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_HOLE_PARTS_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// The original vertices on the rims of the parts of a hole that lie in roofs.
struct RoofParts {
  std::vector<int32_t> joined;                   // the fill of the part joins the rim here
  std::vector<std::pair<int32_t, float>> below;  // the fill passes above these, at this height in metres
};

// Where a roof is open together with the street beside it, the hole goes through a gap in the facade. Seen from above
// it then has two parts, which a narrow neck between objects joins. Like a hole whose whole rim stands on objects, the
// part in the roof is filled as the roof goes on.
//
// Squares of 1.5 m around the rim's objects are taken from the region. Where the neck is narrower (across a diagonal,
// than 2.1 m), what is left falls apart. A part of more than 1 m2 lies in a roof if walls between its rim and the level
// of its objects (the median) are less than half of the walls between its rim and the ground. At least one other part
// has to lie in the ground. Rims steeper than 45 degrees do not count. Rim vertices nearer to the ground than to the
// level are below. docs/decisions/2026-11-29-parts-of-holes.md has the experiments.
//
//   holes  a group of GroupHoles
//
// The same for any division of the group into holes. Each vertex is in one list at most. Cost O(n log n) in the rim's
// segments and in the places where lines, 0.25 m apart, cross them or meet the squares; memory O(n) and 24 bytes for
// each crossing. Holes with more than 4 million of these, or of more than 262 km from south to north, have no parts.
RoofParts FindRoofParts(const Plan& plan, const std::vector<int32_t>& holes);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_HOLE_PARTS_H_
