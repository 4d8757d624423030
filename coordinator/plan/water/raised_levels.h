// Stretches of a shore that walls lift off the ground: roofs that are too wide for an opening to tell.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_RAISED_LEVELS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_RAISED_LEVELS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/tri_mesh.h"
#include "coordinator/plan/water/shore_line.h"

namespace tilemend {

// Figures by measurement (docs/decisions/2026-11-22-shore.md).
struct LevelRule {
  double lift = 13;       // metres: what a wall lifts by at least, four storeys
  double same_level = 2;  // metres: the ground goes on behind an object that is no further up or down
  double slope = 0.6;     // less is ground, as ObjectRule::slope
  double noise = 0.3;     // metres, as ObjectRule::step_noise
  double across = 50;     // metres: levels that are compared across the hole are no farther apart
  double ledge = 10;      // metres of shore: a ledge is shorter
  double ledge_lift = 3;  // metres over the ground on the object's other side: a ledge is higher
};

// Which points of a shore stand on raised levels, though they seem to be ground. A level is a stretch of ground along
// the shore up to the next wall: a rise or fall by `lift` that is steeper than ground. It goes on behind an object with
// about the same height on both sides. From one level to another that walls lead to, the height is that of these walls,
// so that slopes do not count. Where most of such a shore is, is ground; raised is what is `lift` higher. What no wall
// leads to is ground, but for a ledge: a short stretch on an object that leads to a raised level too.
//
// Where the shore ends at the edge of the area, what stands there is seen from one side alone. Levels at such ends are
// compared across the hole as well: with what is as high, and with what is lower by a wall.
//
//   edges  those of the shore, into the points, in any order and direction
//   ends   points where the shore ends at the edge of the area
// Metres. Cost near-linear, the square of the levels that walls join, and for points of levels at ends those near them.
std::vector<bool> OnRaisedLevels(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                                 std::span<const DirectedEdge> edges, std::span<const int32_t> ends = {},
                                 const LevelRule& rule = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_RAISED_LEVELS_H_
