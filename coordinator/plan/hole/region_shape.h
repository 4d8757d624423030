// Shape figures of hole boundaries: planar regions on the lattice, single-hole types, cell types.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_REGION_SHAPE_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_REGION_SHAPE_H_

#include <span>
#include <vector>

#include "common/mesh/triangulation/region_triangulation.h"
#include "coordinator/plan/hole/hole_regions.h"
#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// The regions that segments bound, seen from above, on the lattice window of their vertices.
struct PlanarRegions {
  std::vector<int32_t> vertices;  // local -> global
  RegionTriangulation triangulation;
  std::vector<double> area;  // of each component, m2
};

PlanarRegions FindPlanarRegions(std::span<const RimSegment> segments, const std::vector<Point3>& position);

// Whether p lies in component `component` of the regions (seen from above).
bool Contains(const PlanarRegions& regions, int32_t component, const Point2& p, const std::vector<Point3>& position);

// Vector area of a loop (Newell): its length is the area of the loop's flattest projection, its direction the normal.
Eigen::Vector3d VectorArea(std::span<const RimSegment> loop, const std::vector<Point3>& position);

// Zhang 2022, 4.1, for a closed hole: the outer loop and its islands' outlines.
SingleType ClassifySingle(std::span<const RimSegment> outer, const std::vector<std::vector<RimSegment>>& islands,
                          const std::vector<Point3>& position);

// Wang 2021, 3.1, by the stretches of the cell's outline that the hole takes up: what is left of the outline falls into
// one arc for each part of the surface.
HoleType ClassifyOpen(std::span<const BoundarySegment> segments, CellId cell, bool has_surface, const CutLines& lines,
                      const std::vector<Point3>& position);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_REGION_SHAPE_H_
