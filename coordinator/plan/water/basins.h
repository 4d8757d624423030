// Holes as basins of water, and which of them hold the same water across a bridge.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_BASINS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_BASINS_H_

#include <cstddef>
#include <optional>
#include <vector>

#include "coordinator/plan/water/level_evidence.h"
#include "coordinator/plan/water/river.h"

namespace tilemend {

// A hole, the holes of a cluster, or several of these that hold one water.
struct Basin {
  std::vector<size_t> members;                      // numbers of those that it was joined from, ascending
  std::vector<std::vector<PlaneSegment>> outlines;  // of each member, in the order of joining
  std::vector<RimChain> rim;                        // not empty
  double area = 0;                                  // m2
  LevelEvidence evidence;                           // as a lake
  std::optional<FallingWater> river;                // not empty: it falls

  bool is_level() const { return river || evidence.is_level(); }
  // In the mean, metres: the area over half the outline, with what of that is the edge of the area.
  double Width() const;
};

// A basin with its evidence. `min_river`: of rivers, metres in the mean. `is_known_river`: as for FindFall.
// Precondition: the rim has an edge.
Basin MakeBasin(size_t number, std::vector<PlaneSegment> outline, std::vector<RimChain> rim, double area,
                double min_river, bool is_known_river = false);

// The same of several members that are one, with an outline each. Precondition: at least one.
Basin MakeBasin(std::vector<size_t> members, std::vector<std::vector<PlaneSegment>> outlines, std::vector<RimChain> rim,
                double area, double min_river, bool is_known_river = false);

// Joins basins that hold one water: the nearest first, no farther apart than they are wide together. They do in these
// cases:
//   both alone are level: they are level together, at a level that is no farther from that of either than three times
//                         its sigma
//   one alone is level:   J < D / 2 for both together, at a level in the lower half of the other's rim, and close to
//                         the foot of it (its 2 % quantile; closer than half the way from there to its median, and no
//                         farther than three times the sigma)
//   a river together:     the same holds for the rim of each above that river
// Cost: for basins that are near, O(n log n) as a rule in their outlines where these are near, and MakeBasin's for
// both. Deterministic.
std::vector<Basin> JoinBasins(std::vector<Basin> basins, double min_river);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_BASINS_H_
