// Which holes are water: filled flat, one level for each body of water over any number of cells.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_WATER_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_WATER_H_

#include <functional>

#include "coordinator/plan/seam/seam_heights.h"
#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/known_water.h"

namespace tilemend {

// Fills plan.water, plan.evidence, PlannedHole::water and PlannedHole::evidence, and sets PlanVertex::on_object of the
// original rim vertices that stand more than a metre above their water. Judged are clusters of open holes, and closed
// holes that face up and project, with an edge of original surface on their rim.
//
// A reviewer's decision goes first, unless it accepts what was found. Then the last area in options.areas that covers
// more than half of a cluster or closed hole decides on it, unless the whole rim lies above what the area clears. No
// hole is filled flat if its area says that there is no water. Else its level is the area's, or LevelEvidence::level.
// Those of one area are one body if CanBeOneLevel. Along a given centreline the water falls (FitRiver). A lake whose
// area gives no level has that of the water that it joins across a bridge (JoinBasins), of other areas or found.
//
// Where none decides and options.find is set (docs/decisions/2026-11-26-water-by-evidence.md):
//   water         its rim is level (LevelEvidence::is_level), or a river's (FindFall), alone or with that of others
//                 across a bridge (JoinBasins), but for parts with low ground around them; little of the ground around
//                 it is as low (GroundAround::low, kMaxLowGround); it is as large as options.profile asks
//   level ground  not water, but level and dry surface differ by less than three times the noise, or it is smaller
//                 water, of profile.least_level at least: filled flat too
// Holes that are parts of `known` water of the whole scene are that water first. A reconstruction area may leave too
// little of a shore. Exceptions are holes where an area forbids water or gives its level. The others of their group are
// judged by themselves.
//
// Levels are rounded to the lattice. Once cancelled it ends soon, and the plan is not to be used. Cost as AreaIndex for
// each group, EvidenceOf, JoinBasins and GroundAroundShores. Deterministic.
void FindWater(const PlanInput& input, const WaterOptions& options, KnownWater known, Plan& plan,
               const std::function<bool()>& is_cancelled = {});

// Gives the seam vertices of all that is filled flat their level.
void SettleWater(const Plan& plan, SeamHeights& heights);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_WATER_H_
