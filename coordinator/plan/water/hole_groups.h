// What a body of water can be: a cluster of open holes, or a closed hole.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_HOLE_GROUPS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_HOLE_GROUPS_H_

#include <algorithm>
#include <cstdint>
#include <vector>

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/area_cover.h"

namespace tilemend {

// The angle between a hole and the horizontal, by its vector area, radians: 0 where it is level, pi / 2 in a facade.
double SlopeOf(const Plan& plan, const PlannedHole& hole);

// The clusters of open holes, and the closed holes that face up; each in order of their first hole. Holes that can't be
// filled are in none. `with_left`: those that a reviewer leaves open are in the groups all the same. Cost O(n log n) in
// the plan's holes and segments.
std::vector<std::vector<int32_t>> GroupHoles(const Plan& plan, bool with_left = false);

// The same of all holes, also of those that can't be filled or do not face up. Cost O(n log n) in the plan's holes.
std::vector<std::vector<int32_t>> GroupAllHoles(const Plan& plan);

// The boundary of a hole and of the regions that tiles fill of it for themselves.
template <typename Visit>
void ForRimSegments(const PlannedHole& hole, const Visit& visit) {
  std::for_each(hole.segments.begin(), hole.segments.end(), visit);
  for (const std::vector<RimSegment>& region : hole.own_regions) std::for_each(region.begin(), region.end(), visit);
}

// Visits the original vertices on the rim of a body of water, each with its height above the water, metres. Vertices of
// two edges are visited twice.
template <typename Visit>
void ForRimAboveWater(const WaterBody& body, Plan& plan, const Visit& visit) {
  for (const int32_t h : body.holes) {
    ForRimSegments(plan.holes[h], [&](const RimSegment& s) {
      for (const int32_t v : {s.from, s.to}) {
        PlanVertex& vertex = plan.vertices[v];
        if (vertex.index < 0) continue;
        visit(vertex, vertex.position.z() - LevelAt(body, vertex.position.head<2>(), plan.lattice_step));
      }
    });
  }
}

// The original vertices on the rims of the holes; ascending.
std::vector<int32_t> RimVerticesOf(const Plan& plan, const std::vector<int32_t>& holes);

// Rims and seams of the holes, seen from above; seams between two of them occur twice.
std::vector<PlaneSegment> BoundaryOf(const Plan& plan, const std::vector<int32_t>& holes);

// For each hole of `plan` the group of holes of `whole`, a plan of the same grid, that covers more than half of it.
// They must have holes in the same cell. If there is none, -1. Holes that can't be filled are parts of none, nor are
// those that are in `whole` themselves without a group: they lie above or below.
//   group_of  for each hole of `whole`; -1: it is in none
// Cost O(128 * segments) for each pair of holes that meet in a cell.
std::vector<int32_t> GroupsCovering(const Plan& plan, const Plan& whole, const std::vector<int32_t>& group_of);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_HOLE_GROUPS_H_
