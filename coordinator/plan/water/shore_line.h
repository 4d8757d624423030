// The rims of holes as one line of ground and objects.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_SHORE_LINE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_SHORE_LINE_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/tri_mesh.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

enum class ShorePoint : uint8_t { kGround, kOther };  // kOther: on an object, or a point without a height

struct ShoreLine {
  std::vector<Point3> points;
  std::vector<ShorePoint> kinds;
  std::vector<int32_t> vertices;    // of the plan, for each point
  std::vector<DirectedEdge> edges;  // into the points, the hole on their left; none along seams
};

// The rims of the holes as the plan has them, and those of the regions that tiles fill for themselves as well.
ShoreLine ShoreLineOf(const Plan& plan, const std::vector<int32_t>& holes);
ShoreLine WholeShoreLineOf(const Plan& plan, const std::vector<int32_t>& holes);

// Two points of the ground, neighbours along the shore.
struct GroundLink {
  int32_t a = 0, b = 0;
  bool over_object = false;
};

// The ground beside each object of a shore, the lowest point first. An object is what hangs together by edges between
// points that are no ground.
std::vector<std::vector<int32_t>> GroundBesideObjects(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                                                      std::span<const DirectedEdge> edges);

// Along edges of the ground, and over each object between the lowest point beside it and the others.
std::vector<GroundLink> LinkGround(std::span<const ShorePoint> kinds, std::span<const DirectedEdge> edges,
                                   const std::vector<std::vector<int32_t>>& beside_objects);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_SHORE_LINE_H_
