#include "worker/fill/shape/flip_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "common/mesh/triangulation/delaunay.h"

namespace tilemend {
namespace {

using internal::DelaunayMesh;
using internal::MeshTriangle;
using internal::Next;
using internal::Previous;

// Triangles of a shape below this are poor. A right triangle with equal legs has 0.87.
constexpr double kPoorShape = 0.8;
// A flip that gains less is not worth it, and could be a matter of rounding.
constexpr double kLeastGain = 1e-3;
// A flip must not make a sharper edge than there was; this much is no matter (three degrees, from none).
constexpr double kLargestCosineLoss = 1e-3;
constexpr int32_t kWall = -1;

class Flipper {
 public:
  Flipper(const std::vector<Triangle>& triangles, std::span<const LatticePoint> plane, std::span<const Point3> points,
          std::span<const RegionSegment> walls, const std::function<bool(int32_t, int32_t)>& may_join)
      : points_(points), may_join_(may_join) {
    for (const LatticePoint& p : plane) mesh_.points.push_back(internal::Narrow(p));
    for (const RegionSegment& s : walls) walls_.emplace_back(std::minmax(s.from, s.to));
    std::sort(walls_.begin(), walls_.end());
    mesh_.triangles.reserve(triangles.size());
    for (const Triangle& t : triangles) mesh_.triangles.push_back({t, 0, {kWall, kWall, kWall}, 0});
    LinkTriangles();
  }

  std::vector<Triangle> Run() {
    const auto count = static_cast<int32_t>(mesh_.triangles.size());
    for (int32_t t = 0; t < count; ++t) {
      if (ShapeOf(t) < kPoorShape) FlipFrom(t);
    }
    std::vector<Triangle> result;
    result.reserve(mesh_.triangles.size());
    for (const MeshTriangle& t : mesh_.triangles) result.push_back(t.corner);
    return result;
  }

 private:
  // Finds the twin of each half-edge among those that leave its target.
  void LinkTriangles() {
    std::vector<int32_t> first(mesh_.points.size() + 1, 0);
    const auto for_half_edges = [&](auto&& visit) {
      const auto count = static_cast<int32_t>(mesh_.triangles.size());
      for (int32_t t = 0; t < count; ++t) {
        for (int32_t e = 4 * t; e < 4 * t + 3; ++e) visit(e);
      }
    };
    for_half_edges([&](int32_t e) { ++first[static_cast<size_t>(mesh_.Origin(e)) + 1]; });
    for (size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<int32_t> leaving(3 * mesh_.triangles.size());
    std::vector<int32_t> next(first.begin(), first.end() - 1);
    for_half_edges([&](int32_t e) { leaving[static_cast<size_t>(next[mesh_.Origin(e)]++)] = e; });
    for_half_edges([&](int32_t e) {
      for (int32_t i = first[mesh_.Target(e)]; i < first[mesh_.Target(e) + 1]; ++i) {
        if (mesh_.Target(leaving[i]) == mesh_.Origin(e)) mesh_.triangles[e >> 2].twin[e & 3] = leaving[i];
      }
    });
  }

  double Shape(int32_t a, int32_t b, int32_t c) const {
    const Eigen::Vector3d ab = points_[b] - points_[a], ac = points_[c] - points_[a];
    return 2 * std::sqrt(3.0) * ab.cross(ac).norm() / (ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm());
  }

  double ShapeOf(int32_t t) const {
    const auto& [a, b, c] = mesh_.triangles[t].corner;
    return Shape(a, b, c);
  }

  Eigen::Vector3d Normal(const Triangle& t) const {
    return (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]).normalized();
  }

  double CosineBetween(const Triangle& s, const Triangle& t) const { return Normal(s).dot(Normal(t)); }

  bool Turns(int32_t a, int32_t b, int32_t c) const {
    return internal::Turn(mesh_.points[a], mesh_.points[b], mesh_.points[c]) > 0;
  }

  bool Gains(int32_t e) const {
    const int32_t twin = mesh_.Twin(e);
    if (twin < 0) return false;
    const int32_t a = mesh_.Origin(e), b = mesh_.Target(e), p = mesh_.Apex(e), q = mesh_.Apex(twin);
    if (!Turns(p, a, q) || !Turns(q, b, p)) return false;
    const double before = std::min(ShapeOf(e >> 2), ShapeOf(twin >> 2));
    return std::min(Shape(p, a, q), Shape(q, b, p)) > before + kLeastGain &&
           CosineBetween({p, a, q}, {q, b, p}) >= CosineBetween({p, a, b}, {q, b, a}) - kLargestCosineLoss &&
           !std::binary_search(walls_.begin(), walls_.end(), std::pair<int32_t, int32_t>(std::minmax(a, b))) &&
           may_join_(p, q);
  }

  // Flips what gains around a triangle, then around what that changed.
  void FlipFrom(int32_t first) {
    todo_.assign(1, first);
    while (!todo_.empty()) {
      const int32_t t = todo_.back();
      todo_.pop_back();
      for (int32_t e = 4 * t; e < 4 * t + 3; ++e) {
        if (!Gains(e)) continue;
        const int32_t u = mesh_.Twin(e) >> 2;
        mesh_.Flip(e);
        todo_.insert(todo_.end(), {t, u});
        break;
      }
    }
  }

  DelaunayMesh mesh_;
  std::span<const Point3> points_;
  const std::function<bool(int32_t, int32_t)>& may_join_;
  std::vector<std::pair<int32_t, int32_t>> walls_;
  std::vector<int32_t> todo_;
};

}  // namespace

std::vector<Triangle> FlipForShape(const std::vector<Triangle>& triangles, std::span<const LatticePoint> plane,
                                   std::span<const Point3> points, std::span<const RegionSegment> walls,
                                   const std::function<bool(int32_t, int32_t)>& may_join) {
  return Flipper(triangles, plane, points, walls, may_join).Run();
}

}  // namespace tilemend
