// Stretches of a shore that walls lift off the ground: roofs that are too wide for an opening to tell.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_RAISED_LEVELS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_RAISED_LEVELS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Figures by measurement (docs/decisions/2026-11-22-shore.md).
struct LevelRule {
  double lift = 13;       // metres: what a wall lifts by at least, four storeys
  double same_level = 2;  // metres: the ground goes on behind an object that is no further up or down
  double slope = 0.6;     // less is ground, as ObjectRule::slope
  double noise = 0.3;     // metres, as ObjectRule::step_noise
};

enum class ShorePoint : uint8_t { kGround, kOther };  // kOther: on an object, or a point without a height

// Which points of a shore stand on raised levels, though they seem to be ground. A level is a stretch of ground along
// the shore up to the next wall: a rise or fall by `lift` that is steeper than ground. It goes on behind an object with
// about the same height on both sides. From one level to another that walls lead to, the height is that of these walls,
// so that slopes do not count. Where most of such a shore is, is ground; raised is what is `lift` higher. What no wall
// leads to is ground.
//
// `edges` are those of the shore, into the points, in any order and direction. Metres. Cost near-linear, and the
// square of the levels that walls join.
std::vector<bool> OnRaisedLevels(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                                 std::span<const DirectedEdge> edges, const LevelRule& rule = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_RAISED_LEVELS_H_
