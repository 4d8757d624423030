// How much of the surface around a hole lies lower than the water that may be in it.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_LOWER_SURFACE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_LOWER_SURFACE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/level_evidence.h"

namespace tilemend {

// The rim of what may be water.
struct Shore {
  std::vector<Point3> edges;  // middles, with the height of the water there; NaN: the edge is higher
  double mean_edge = 0;       // metres, of the rim
  double noise = 0;           // metres, of the rim's heights; at least kMinSigma counts
};

// For each shore the share (0 to 1) of the low surface around it that is no higher than the water at the nearest edge,
// within three times the noise. It looks at the vertices in the survey's bands, off the rims of holes, that are 4 to 15
// m from the shore. Each square of 1.5 m counts once, by its lowest vertex: roofs have many vertices, streets few. What
// stands 1.5 m and more above the water is an object or a wall, and tells nothing. Where edges are long, the distances
// are 1.5 and 3 mean edges, and the others grow likewise. The nearest edge must be at the water.
// With fewer than ten low squares nothing is known, and the share is 0; so it is if no more than 5 % of all squares are
// no higher: a jetty or a spike.
// Cost O(n log n) in the bands' vertices of the cells around, and the shores.
std::vector<double> LowerShares(const Plan& plan, const PlanInput& input, std::span<const Shore> shores);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_LOWER_SURFACE_H_
