#include "worker/fill/space/unrolled_fill.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "common/mesh/rounding.h"
#include "worker/fill/region/planar_region.h"
#include "worker/fill/space/bend_patch.h"
#include "worker/fill/space/sound_triangulation.h"
#include "worker/fill/space/unrolled.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// The normals of the surface along the loop where it belongs to the same part as the surface that goes on into the
// hole; else zero.
std::vector<Vector3d> NormalsAlong(const LocalHole& hole, const RimLoop& loop) {
  std::vector<Vector3d> normals;
  for (int32_t i = 0; i < loop.size(); ++i) {
    const Vector3d& n = loop.outside[i];
    const Vector3d &from = hole.normals[loop.vertices[i]], &to = hole.normals[loop.vertices[(i + 1) % loop.size()]];
    const bool same = n.dot(from) >= kSamePartCosine && n.dot(to) >= kSamePartCosine;
    normals.push_back(same ? n : Vector3d::Zero());
  }
  return normals;
}

// The new points, in the plane, the share `bend` of the way from the disc to the surface of least bending; none if that
// cannot be found.
std::optional<std::vector<Point3>> BendInSpace(const LocalHole& hole, const Unrolled& disc,
                                               std::span<const Point2> new_points,
                                               const std::vector<Triangle>& triangles, double bend) {
  std::vector<Point3> flat, points;
  for (const Point2& p : disc.flat()) flat.emplace_back(p.x(), p.y(), 0);
  for (const Point2& p : new_points) {
    points.push_back(disc.Lift(p));
    flat.emplace_back(p.x(), p.y(), 0);
  }
  if (bend > 0) {
    const std::optional<std::vector<Point3>> bent = BendPatch(hole, std::move(flat), points, triangles);
    if (!bent) return std::nullopt;
    for (size_t k = 0; k < points.size(); ++k) points[k] += bend * ((*bent)[k] - points[k]);
  }
  for (Point3& p : points) p = RoundedToLattice(p, hole.cell->lattice_step);
  return points;
}

}  // namespace

LocalPatch FillUnrolled(const LocalHole& hole, const FillOptions& options) {
  if (hole.loops.size() != 1 || hole.size() > kLongestSpatialLoop) return {FillFailure::kNotApplicable};
  const RimLoop& loop = hole.loops[0];
  std::vector<Triangle> triangles = TriangulateSoundly(
      loop.positions, NormalsAlong(hole, loop),
      [&](int32_t i, int32_t k) { return hole.MayJoin(loop.vertices[i], loop.vertices[k]); }, CrossingIndex({}));
  for (Triangle& t : triangles) t = {loop.vertices[t[0]], loop.vertices[t[1]], loop.vertices[t[2]]};
  return FillOver(std::move(triangles), 1, hole, options);
}

LocalPatch FillOver(std::vector<Triangle> triangles, double bend, const LocalHole& hole, const FillOptions& options) {
  if (hole.loops.size() != 1 || triangles.empty() || hole.loops[0].size() != hole.size()) {
    return {FillFailure::kNotApplicable};
  }
  const Unrolled disc(hole.positions, std::move(triangles));
  const PlanarPoints planar = RoundToWindow(disc.flat(), hole.sizes);
  RefinedRegion region = RefineRegion(planar.points, hole.segments, planar.sizes, options.refine);
  if (!region.triangulation.conflicts.empty()) return {FillFailure::kNotApplicable};
  std::vector<Point2> new_points;
  for (const LatticePoint& p : region.new_points) new_points.push_back(planar.window.ToMetres(p));
  LocalPatch patch;
  patch.triangles = std::move(region.triangulation.triangles);
  std::optional<std::vector<Point3>> points = BendInSpace(hole, disc, new_points, patch.triangles, bend);
  if (!points) return {FillFailure::kNotApplicable};
  patch.new_points = *std::move(points);
  return patch;
}

}  // namespace tilemend
