// How much of the ground around a hole is no higher than the water that may be in it.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_LOW_GROUND_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_LOW_GROUND_H_

#include <cstdint>
#include <span>
#include <vector>

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/level_evidence.h"

namespace tilemend {

inline constexpr double kMaxLowGround = 0.17;  // GroundAround::low of water
inline constexpr double kMaxSunkGround = 0.5;  // GroundAround::sunk of what is level within noise

// The rim of what may be water.
struct Shore {
  std::vector<Point3> edges;  // middles, with the height of the water there; NaN: the edge is higher
  double mean_edge = 0;       // metres, of the rim
  double noise = 0;           // metres, of the rim's heights; at least kMinSigma counts
};

// Shares of the ground around a shore, 0 to 1. If most is sunk, the rim tells the crowns of trees.
struct GroundAround {
  double low = 0;   // no more than .15 m higher than the water at the nearest edge
  double sunk = 0;  // lower than that water by more than three times the noise of the rim
};

// For each shore. It looks at squares of 3 m with ground, 4 to 15 m from the shore (RimGround::around). The nearest
// edge must be at the water. What is low is not measured by the noise of the rim, which has crowns of trees in it.
//
// The vertices of the survey's bands count instead where these squares are not told or wider than 6 m, or where edges
// are longer than 5 m: then the distances are 1.5 and 3 mean edges. They lie off the rims of holes; the lowest in each
// square of 1.5 m counts. It is low up to three times the noise of the rim, as bands end where shores are low. What
// stands 1.5 m and more above the water is an object there, and tells nothing.
//
// With fewer than five squares with ground, or ten of bands, nothing is known, and the shares are 0. So is `low` if no
// more than 5 % of all squares are low: a jetty or a spike.
//
// Cost O(n log n) in the squares and the bands' vertices of the cells around, for each shore there.
std::vector<GroundAround> GroundAroundShores(const Plan& plan, const PlanInput& input, std::span<const Shore> shores);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_LOW_GROUND_H_
