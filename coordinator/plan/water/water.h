// Which holes are water: filled flat, one level for each body of water over any number of cells.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_WATER_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_WATER_H_

#include "coordinator/plan/seam/seam_heights.h"
#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/known_water.h"

namespace tilemend {

// Fills plan.water and PlannedHole::water, and sets PlanVertex::on_object of the original rim vertices that stand more
// than a metre above their water. A body of water is a cluster of open holes or a
// closed hole that faces up and projects, with at least one original vertex on its rim.
//
// The last area in options.areas that covers more than half of it decides. Lakes of one area are one body where their
// shores' levels are no farther from that of the largest than the tolerance and its spread, or two tolerances. What a
// given centreline does not run through is no part of its river if its shore is off that by as much. Where
// none does and options.find is set, it is water if all of this holds (docs/decisions/2026-11-21-water.md), with a
// slack of the tolerance, or of 0.1 % of the extent if that is less:
//   - its rim has at least 24 vertices; their heights spread no more than the tolerance about where they gather, and no
//     more than the slack and two standard deviations of noise;
//   - the plane fitted to them falls over the whole extent no more than the slack;
//   - in at least seven of eight stretches of the rim the lower quartile is that of the whole rim, within the slack,
//   and
//     the ground one edge landward is not below the level in the median; nor is it so in the median of the whole rim;
//   - if the rim has fewer than 96 vertices, the ground rises from it.
// Each figure may be off by three standard errors more, but no more than the tolerance, for the noise that is measured
// beside the rim (ShoreGround::noise); the ground has to rise by more than that.
//
// Where `known` water decides on a cluster it does, unless an area forbids it or gives a level. In clusters that are
// none by all of this the holes that are parts of it are water.
//
// The level is FitRimLevel's, rounded down to the lattice. Cost O(n log n) in rims and bands. Deterministic.
void FindWater(const PlanInput& input, const WaterOptions& options, KnownWater known, Plan& plan);

// Gives the seam vertices of all water their level.
void SettleWater(const Plan& plan, SeamHeights& heights);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_WATER_H_
