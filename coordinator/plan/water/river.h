// Rivers: water that falls along the middle of its holes.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_RIVER_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_RIVER_H_

#include <optional>
#include <span>
#include <vector>

#include "common/records/water_surface.h"
#include "coordinator/plan/water/area_cover.h"
#include "coordinator/plan/water/level_evidence.h"

namespace tilemend {

struct FallingWater {
  WaterSurface water;      // downstream, on a straight line in height
  LevelEvidence evidence;  // of the rim, each edge moved up or down by the fall to the river's lower end
};

// The line along the middle of one or more holes that are reaches of one water. It is their centrelines
// (FindCentrelines), in line where they end nearest to each other, without the bends into corners there. Empty: no
// reach is longer than wide, or `min_width` metres wide in the mean. Cost: FindCentrelines' for each.
std::vector<Point2> RiverAxis(std::span<const std::vector<PlaneSegment>> reaches, double min_width);

// Whether a rim may be that of falling water: its level's J is more than its noise.
bool MayFall(const LevelEvidence& level);

// The river along an axis, if a falling line explains its rim far better than a level does. The moved rim is then
// level, and its J is less than a third of that of `level`, which judges the rim as a lake. It must be less than a
// fifth if fewer than eight stations have a level. It need only be less if a part of the water is known to fall. Four
// stations have to have one, and MayFall(level). Preconditions: the axis has at least two points,
// the rim an edge. Cost: FitFall's, and EvidenceOf's.
std::optional<FallingWater> FindFall(const std::vector<Point2>& axis, std::span<const RimChain> rim,
                                     std::span<const PlaneSegment> outline, const LevelEvidence& level,
                                     bool is_known_river = false);

// The same rim with heights above the water of a river.
std::vector<RimChain> AboveRiver(const WaterSurface& river, std::vector<RimChain> rim);

// Whether levels that are so far apart (metres) can be one: no farther than three sigmas of both, or 6 cm.
bool CanBeOneLevel(double apart, const LevelEvidence& a, const LevelEvidence& b);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_RIVER_H_
