// Terraces: level stretches of a shore that lie higher than the ground all around.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_TERRACES_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_TERRACES_H_

#include <span>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/tri_mesh.h"
#include "coordinator/plan/water/shore_line.h"

namespace tilemend {

// Figures by measurement (docs/decisions/2026-11-22-shore.md).
struct TerraceRule {
  double lift = 3;        // metres over the ground around
  double extent = 14;     // metres: a terrace reaches no less far
  double slope = 0.6;     // less is ground, as ObjectRule::slope
  double noise = 0.3;     // metres, as ObjectRule::step_noise
  double same_level = 2;  // metres: ground goes on behind an object that is no further up or down
  double beside = 5;      // metres of shore: what is shorter tells nothing of what lies around
  double around = 50;     // metres
  double share = 0.5;     // of the ground around: no less is lower by the lift
  double scrap = 10;      // metres of shore: a scrap is shorter
  double near = 30;       // metres: a scrap is no farther away
};

// Which points of a shore stand on terraces, though they seem to be ground: decks and podiums whose walls are hidden by
// what stands beside them. A stretch is ground that hangs together along edges that are no steeper than ground, and
// over objects with about the same height on both sides. A terrace is a wide stretch where all ways off lead over
// objects down by `lift` or more, and where half of the ground around is lower by as much; other such stretches do not
// count there. A wall that is seen is a step of the ground. Short stretches near a terrace that are not lower are
// scraps of it.
//
//   edges  those of the shore, into the points, in any order and direction
// Metres. Cost near-linear, and for points of terraces the ground around each.
std::vector<bool> OnTerraces(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                             std::span<const DirectedEdge> edges, const TerraceRule& rule = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_TERRACES_H_
