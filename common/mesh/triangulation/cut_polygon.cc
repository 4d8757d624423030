#include "common/mesh/triangulation/cut_polygon.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "common/mesh/lattice.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// Of the face's squared area: triangles of a convex face that are turned over by less are flat, and rounded.
constexpr double kFlat = 1e-9;

void MakeFan(int32_t size, std::vector<Triangle>& triangles) {
  triangles.clear();
  for (int32_t i = 2; i < size; ++i) triangles.push_back({0, i - 1, i});
}

bool IsKnown(std::span<const int32_t> corners, std::span<const Point3> points) {
  return std::ranges::all_of(corners, [&](int32_t v) { return v >= 0 && v < std::ssize(points); });
}

bool IsFan(std::span<const Point3> face, const Vector3d& normal) {
  for (size_t i = 2; i < face.size(); ++i) {
    const Vector3d area = (face[i - 1] - face[0]).cross(face[i] - face[0]);
    if (area.dot(normal) < -kFlat * normal.squaredNorm()) return false;
  }
  return true;
}

// Seen against the axis that the normal is most nearly along: the face runs counter-clockwise.
std::vector<LatticePoint> SeenAlong(const Vector3d& normal, std::span<const Point3> face) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<Point2> flat;
  for (const Point3& p : face) flat.push_back(normal[axis] > 0 ? Point2(p[u], p[v]) : Point2(p[v], p[u]));
  Point2 lo = flat[0], hi = lo;
  for (const Point2& p : flat) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  const LatticeWindow window(lo, hi);
  std::vector<LatticePoint> places;
  for (const Point2& p : flat) places.push_back(window.Round(p));
  return places;
}

}  // namespace

void CutPolygon(std::span<const int32_t> corners, std::span<const Point3> points, std::vector<Triangle>& triangles) {
  const auto size = static_cast<int32_t>(corners.size());
  MakeFan(size, triangles);
  if (size == 3 || !IsKnown(corners, points)) return;
  std::vector<Point3> face;
  for (const int32_t v : corners) face.push_back(points[v]);
  Vector3d normal = Vector3d::Zero();  // twice the vector area
  for (int32_t i = 2; i < size; ++i) normal += (face[i - 1] - face[0]).cross(face[i] - face[0]);
  if (IsFan(face, normal)) return;
  std::vector<RegionSegment> sides;
  for (int32_t i = 0; i < size; ++i) sides.push_back({i, (i + 1) % size});
  const RegionTriangulation cut = TriangulateRegion(SeenAlong(normal, face), sides);
  if (std::ssize(cut.triangles) != size - 2) return;
  triangles = cut.triangles;
}

}  // namespace tilemend
