#include "worker/fill/hole/facing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "worker/fill/region/planar_region.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// Enough for a direction to within about a degree.
constexpr int kViewSteps = 200;
// Over a plane triangles are stretched by one over the cosine of the slope; twice is too much if at more than a tenth
// of the rim. Bending over a plane is that in space only where it is nearly level: in a mesh that may lie in any way
// there is no other reason to keep to the plane.
constexpr double kSteepCosine = 0.5;
constexpr double kSteepCosineAnyWay = 0.99;
constexpr double kSteepShare = 0.1;

}  // namespace

Vector3d FacingOf(const LocalHole& hole) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& normal : hole.normals) sum += normal;
  return sum;
}

Vector3d WidestView(const LocalHole& hole) {
  std::vector<Vector3d> normals;
  for (const RimLoop& loop : hole.loops) normals.insert(normals.end(), loop.outside.begin(), loop.outside.end());
  Vector3d view = FacingOf(hole).normalized();
  for (int k = 2; k < kViewSteps; ++k) {
    const Vector3d* furthest = nullptr;
    for (const Vector3d& n : normals) {
      if (!n.isZero() && (furthest == nullptr || n.dot(view) < furthest->dot(view))) furthest = &n;
    }
    if (furthest != nullptr) view = (view + (*furthest - view) / k).normalized();
  }
  return view;
}

bool IsSteep(const LocalHole& hole) {
  const Vector3d facing = FacingOf(hole).normalized();
  const double least = hole.cell->upright ? kSteepCosine : kSteepCosineAnyWay;
  int32_t steep = 0, rim = 0;
  for (const Vector3d& normal : hole.normals) {
    if (normal.isZero()) continue;
    ++rim;
    steep += normal.dot(facing) < least;
  }
  return steep > kSteepShare * rim;
}

ProjectionFrame FrameAcross(const LocalHole& hole, const Vector3d& normal) {
  if (hole.cell->upright) return {hole.positions[0], normal};
  return {hole.positions[0], normal, hole.positions[hole.positions.size() / 2] - hole.positions[0]};
}

ProjectionFrame FrameOfHeights(const LocalHole& hole) {
  const Vector3d view = hole.cell->upright ? Vector3d::Zero() : WidestView(hole);
  return view.isZero() ? ProjectionFrame::Upright() : FrameAcross(hole, view);
}

bool FacesUp(const LocalHole& hole, const ProjectionFrame& frame) {
  return std::all_of(hole.vertices.begin(), hole.vertices.end(), [&](int32_t v) {
    const std::vector<int32_t>& triangles = hole.band->At(v);
    return std::all_of(triangles.begin(), triangles.end(),
                       [&](int32_t t) { return frame.HeightAlong(hole.band->Normal(t)) > 0; });
  });
}

bool LiesInHeightField(const LocalHole& hole, const ProjectionFrame& frame) {
  if (!FacesUp(hole, frame)) return false;
  std::vector<Point2> flat;
  for (const Point3& p : hole.positions) flat.emplace_back(frame.ToFrame(p).head<2>());
  return TriangulateRegion(RoundToWindow(flat, hole.sizes).points, hole.segments).conflicts.empty();
}

}  // namespace tilemend
