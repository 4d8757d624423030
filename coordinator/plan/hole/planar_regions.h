// The regions that boundary segments bound, seen from above.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_PLANAR_REGIONS_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_PLANAR_REGIONS_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/triangulation/region_triangulation.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// On the lattice window of the segments' vertices.
struct PlanarRegions {
  std::vector<int32_t> vertices;  // local -> global
  RegionTriangulation triangulation;
  std::vector<double> area;  // of each component, m2
};

// The regions to the left of the segments. `position` is by vertex. Cost O(n log n), exact topology.
PlanarRegions FindPlanarRegions(std::span<const RimSegment> segments, const std::vector<Point3>& position,
                                const std::function<bool()>& is_cancelled = {});

// Whether p lies in component `component` of the regions. Cost O(triangles).
bool Contains(const PlanarRegions& regions, int32_t component, const Point2& p, const std::vector<Point3>& position);

// Vector area of a loop (Newell): its length is the area of the loop's flattest projection, its direction the normal.
// Precondition: the loop has segments.
Eigen::Vector3d VectorArea(std::span<const RimSegment> loop, const std::vector<Point3>& position);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_PLANAR_REGIONS_H_
