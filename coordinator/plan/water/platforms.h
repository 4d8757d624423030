// Platforms that objects on both shores stand on: a podium between towers.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_PLATFORMS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_PLATFORMS_H_

#include <span>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/tri_mesh.h"
#include "coordinator/plan/water/shore_line.h"

namespace tilemend {

// Figures by measurement (docs/decisions/2026-11-22-shore.md).
struct PlatformRule {
  double roughness = 2.5;  // metres: the heights of a shelf differ by no more, nor do those of two shelves
  double extent = 3;       // metres along the shore: a shelf is no shorter
  double lift = 3;         // metres over the ground beside: a shelf is no lower
  double beside = 10;      // metres: that ground is no farther away
  double tower = 13;       // metres over the shelf: what stands on it is no lower, four storeys
  double across = 50;      // metres: towers on one platform are no farther apart
  double spacing = 2;      // metres, of points along the platform's walls
  double wall = 0.5;       // metres: how far in front of the top the foot of a wall lies
};

// The ground of platforms, for a surface that is linear between points. Where the way from the ground beside an object
// up to its top has a level shelf, the object is a tower on a platform that the shelf is an edge of. Where another
// tower stands across the hole and its shelf is as high, the platform goes on between them, and ends in walls from one
// to the other: between the shelves where both have one at that end, else where the first of them ends. The points are
// those of the towers at the height of the shelves, and of the tops and the feet of the two walls.
//
//   edges  those of the shore, into the points, each once, the hole on their left
// Metres. Cost near-linear, and the square of the towers.
std::vector<Point3> FindPlatforms(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                                  std::span<const DirectedEdge> edges, const PlatformRule& rule = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_PLATFORMS_H_
