// Which points of a shore stand on something: a tree, a house, a deck, the top of a wall.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_SHORE_OBJECTS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_SHORE_OBJECTS_H_

#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Figures by measurement (docs/decisions/2026-11-22-shore.md).
struct ObjectRule {
  double radius = 10;         // metres: wider things count as ground
  double least_height = 0.5;  // metres, above what is left when the heights are opened
  double step_noise = 0.3;    // metres: steps lower than this tell nothing
  double slope = 0.6;         // less is ground
  double rough = 0.3;         // steps of rough ground are steeper; as those of things are
  double wall = 2;            // more is a wall
};

// For each rim point how steep the way down from it is; 0 where it lies at most least_height above the morphological
// opening of all heights (rim and surroundings) with a disc of the radius: ground is what such a disc fits on from
// below. Steep is the way to the point within the radius for which the difference of heights, less step_noise, over the
// distance is largest. The trend of the lowest points has been taken away from all heights.
//
// Points are metres, in any order and frame; NaN is not allowed. Heights are taken as the lowest of squares of a tenth
// of the radius, so that the cost is at most linear in the points plus 600 times the squares that are not empty.
std::vector<double> StepsDown(std::span<const Point3> rim, std::span<const Point3> surroundings,
                              const ObjectRule& rule = {});

// Whether the steps are those of things that stand there, and not of rough ground: at least a third of those steeper
// than `rough` are steeper than `wall`. Things have a wall or nothing; slopes of rough ground have all steepnesses.
// Mountains have steep ones all over: where more than half of all steps are steeper than `rough`, four in five of
// those steeper than `slope` must be walls. A point whose step is steeper than `slope` then stands on an object.
bool AreWalls(std::span<const double> steps, const ObjectRule& rule = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_SHORE_OBJECTS_H_
