// How far a hole's dry surface is from level water: a membrane over the hole on a coarse raster.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_RIM_MEMBRANE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_RIM_MEMBRANE_H_

#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "coordinator/plan/water/area_cover.h"

namespace tilemend {

// The mean over the hole of |S - level|, metres. S is harmonic in the hole; outside of it, beside its outline, it is as
// high as the nearest of `heights`.
//
//   outline  of the hole, seen from above (even-odd rule; segments that occur twice bound nothing)
//   heights  places on its rim, at least one
// Cost: about 1,000 squares inside, on a raster of at most 500 a side. Deterministic.
double MeanOffLevel(std::span<const PlaneSegment> outline, std::span<const Point3> heights, double level);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_RIM_MEMBRANE_H_
