#include "worker/fill/space/bend_patch.h"

#include <utility>

#include "worker/fill/surface/fair_surface.h"

namespace tilemend {

std::optional<std::vector<Point3>> BendPatch(const LocalHole& hole, std::vector<Point3> shape,
                                             std::span<const Point3> new_points,
                                             const std::vector<Triangle>& triangles) {
  const size_t rim = hole.positions.size(), count = new_points.size();
  const BandTriangles band = BandAt(hole, hole.has_equation, static_cast<int32_t>(rim + count));
  FairSurfaceProblem fair;
  fair.points = hole.positions;
  fair.points.insert(fair.points.end(), new_points.begin(), new_points.end());
  for (const int32_t v : band.others) fair.points.push_back(hole.cell->band.points[v]);
  shape.resize(fair.points.size(), Point3::Zero());
  fair.patch = triangles;
  fair.band = band.triangles;
  for (size_t v = 0; v < fair.points.size(); ++v) {
    const bool is_new = v >= rim && v < rim + count;
    fair.known.push_back(!is_new);
    fair.has_equation.push_back(v < rim ? static_cast<bool>(hole.has_equation[v]) : is_new);
  }
  fair.evens_curvature = !hole.cell->upright;
  if (!FairSurface(shape, fair)) return std::nullopt;
  const auto first = fair.points.begin() + static_cast<ptrdiff_t>(rim);
  return std::vector<Point3>(first, first + static_cast<ptrdiff_t>(count));
}

}  // namespace tilemend
