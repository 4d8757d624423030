#include "coordinator/plan/hole/measure_hole.h"

#include <utility>

namespace tilemend {

PlannedHole MeasureHole(CellId cell, std::vector<RimSegment> segments, const std::vector<Point3>& position) {
  PlannedHole hole;
  hole.cell = cell;
  Point2 sum{0, 0};
  for (const RimSegment& s : segments) {
    sum += position[s.from].head<2>();
    if (s.seam) continue;
    hole.perimeter += (position[s.to] - position[s.from]).norm();
    ++hole.boundary_vertices;
  }
  hole.centre = sum / static_cast<double>(segments.size());
  hole.segments = std::move(segments);
  return hole;
}

}  // namespace tilemend
