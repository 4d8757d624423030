// What an area's polygon leaves outside, as surface of a tile that has an outline of its own.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_AREA_OUTSIDE_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_AREA_OUTSIDE_H_

#include <array>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/plane_polygon.h"
#include "coordinator/plan/seam/seam_site.h"

namespace tilemend {

// The rings of the area `input.area` over the whole scene, with new vertices spaced along them (seam/area_ring.h), the
// inside on their right. Cost as RingSpacer.
std::vector<std::vector<Point2>> SpacedRings(const SeamSite& site, const PlanInput& input);

// Part of a box, as directed edges that wind around it once.
struct AreaOutside {
  std::array<double, 4> box{};  // by Side
  std::vector<Point2> points;   // of the rings, where they cross the box, and its corners
  std::vector<DirectedEdge> edges;

  bool empty() const { return edges.empty(); }
  bool Contains(const Point2& at) const;  // beyond the box as at its side; O(edges)
};

// What is outside the area in a box. Empty where that is nothing. `lattice_step` is for new points on the box's sides.
// Cost O(points of the rings).
AreaOutside OutsideIn(const std::vector<std::vector<Point2>>& rings, const std::array<double, 4>& box,
                      double lattice_step);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_AREA_OUTSIDE_H_
