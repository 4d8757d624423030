// Water of the whole scene, where an area takes only a part of it.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_KNOWN_WATER_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_KNOWN_WATER_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct KnownWater {
  std::vector<WaterBody> bodies;  // their `holes` mean nothing here
  std::vector<int32_t> body_of;   // by hole of the plan: the body that it is a part of; -1: of none

  // Whether a hole of the plan is a part of known water.
  bool IsPart(int32_t hole) const { return !bodies.empty() && body_of[hole] >= 0; }
  void Forget(const std::vector<int32_t>& holes);
};

// Finds what the lakes and rivers of `whole`, a plan of the same grid without the area, say of the holes of `plan`. A
// hole is a part of the body that covers it. Level ground of `whole` says nothing: it may be a part of water that
// reaches beyond. Cost as GroupsCovering.
KnownWater FindKnownWater(const Plan& whole, const Plan& plan);

// Takes more of what is known, for holes of which nothing is.
void AddKnownWater(const KnownWater& more, KnownWater& known);

// The parts of known bodies that lie in holes without water, as bodies of the plan. The level is that of the whole; a
// river keeps the stations beside the part.
std::vector<WaterBody> PartsOfKnown(const KnownWater& known, const std::vector<bool>& is_water, const Plan& plan);

// Gives the water's level for good to new vertices between holes that are water and others of their cluster.
void HoldLevelAtEdges(Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_KNOWN_WATER_H_
