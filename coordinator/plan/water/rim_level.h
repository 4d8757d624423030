// The level of water from the heights of its rim.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_RIM_LEVEL_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_RIM_LEVEL_H_

#include <cstddef>
#include <vector>

namespace tilemend {

// Metres: what gathers less high above the water is water with more noise, or ground.
inline constexpr double kLeastQuay = 0.5;

struct RimLevel {
  double level = 0;   // metres
  double spread = 0;  // metres: standard deviation of the heights below where they gather (from their median)
  size_t count = 0;   // of the heights that it was taken from
};

// The level that the heights of a rim gather at. A rim vertex of water lies at the level, or above it on the bank, plus
// noise: so the heights are densest about the level, and on its lower side noise is all there is. The fit starts in the
// middle of the shortest interval with a third of the heights and takes the mean of those within 1.75 spreads, the
// spread from the lower side, until that stays as it is.
//
// No height but an outlier (more than five spreads below) then lies farther below the level than noise of `noise`
// metres (standard deviation between neighbours, >= 0; over the whole rim the spread, at most twice as much) takes the
// lowest of so many: else the level is lowered until that holds. A rim without noise has no vertex below the level.
//
// Precondition: heights are finite, at least one. Cost O(n log n). Deterministic, whatever the order of the heights.
RimLevel FitRimLevel(std::vector<double> heights, double noise);

// The same where most of the rim may stand on quays, all of one height, and the water shows between them alone: if the
// heights gather half a metre higher above the lowest ones than noise explains, the level is looked for among those
// that noise of water at that place could reach, and so on. At least four heights are asked for; with fewer it is
// FitRimLevel's.
RimLevel FitLowLevel(std::vector<double> heights, double noise);

// The value that `share` (0 to 1) of the values lie below, between two of them linearly. Precondition: not empty.
double Quantile(std::vector<double> values, double share);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_RIM_LEVEL_H_
