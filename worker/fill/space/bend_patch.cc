#include "worker/fill/space/bend_patch.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "worker/fill/surface/fair_surface.h"

namespace tilemend {
namespace {

// The triangles at `outer`, points of the cell's band that stand for points from `first` on, but for those at the
// vertices of the hole. Points that they have beyond are added.
std::vector<Triangle> TrianglesBeyond(const LocalHole& hole, const std::vector<int32_t>& outer, size_t first,
                                      std::vector<Point3>& points) {
  std::unordered_map<int32_t, int32_t> number;
  for (const int32_t v : outer) number.emplace(v, static_cast<int32_t>(first + number.size()));
  std::vector<int32_t> used;
  for (const int32_t v : outer) {
    const std::vector<int32_t>& around = hole.band->At(v);
    used.insert(used.end(), around.begin(), around.end());
  }
  for (const int32_t v : hole.vertices) {
    if (v >= 0) number.emplace(v, -1);
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<Triangle> beyond;
  for (const int32_t t : used) {
    Triangle out;
    for (int k = 0; k < 3; ++k) {
      const int32_t v = hole.cell->band.triangles[t][k];
      const auto [it, fresh] = number.try_emplace(v, static_cast<int32_t>(points.size()));
      if (fresh) points.push_back(hole.cell->band.points[v]);
      out[k] = it->second;
    }
    if (std::ranges::find(out, -1) == out.end()) beyond.push_back(out);
  }
  return beyond;
}

}  // namespace

std::optional<std::vector<Point3>> BendPatch(const LocalHole& hole, std::vector<Point3> shape,
                                             std::span<const Point3> new_points,
                                             const std::vector<Triangle>& triangles) {
  const size_t rim = hole.positions.size(), count = new_points.size();
  const BandTriangles band = BandAt(hole, hole.has_equation, static_cast<int32_t>(rim + count));
  FairSurfaceProblem fair;
  fair.points = hole.positions;
  fair.points.insert(fair.points.end(), new_points.begin(), new_points.end());
  for (const int32_t v : band.others) fair.points.push_back(hole.cell->band.points[v]);
  fair.evens_curvature = !hole.cell->upright;
  if (fair.evens_curvature) fair.beyond = TrianglesBeyond(hole, band.others, rim + count, fair.points);
  shape.resize(fair.points.size(), Point3::Zero());
  fair.patch = triangles;
  fair.band = band.triangles;
  for (size_t v = 0; v < fair.points.size(); ++v) {
    const bool is_new = v >= rim && v < rim + count;
    fair.known.push_back(!is_new);
    fair.has_equation.push_back(v < rim ? static_cast<bool>(hole.has_equation[v]) : is_new);
  }
  if (!FairSurface(shape, fair)) return std::nullopt;
  const auto first = fair.points.begin() + static_cast<ptrdiff_t>(rim);
  return std::vector<Point3>(first, first + static_cast<ptrdiff_t>(count));
}

}  // namespace tilemend
