#include "worker/fill/shape/flip_edges.h"

#include <algorithm>
#include <utility>

#include "common/mesh/triangle_shape.h"
#include "worker/fill/mesh/patch_mesh.h"

namespace tilemend {
namespace {

// Triangles of a shape below this are poor. A right triangle with equal legs has 0.87.
constexpr double kPoorShape = 0.8;
// A flip that gains less is not worth it, and could be a matter of rounding.
constexpr double kLeastGain = 1e-3;
// A flip must not make a sharper edge than there was; this much is no matter (three degrees, from none).
constexpr double kLargestCosineLoss = 1e-3;

class Flipper {
 public:
  using HalfEdge = PatchMesh::HalfedgeHandle;
  using Face = PatchMesh::FaceHandle;

  Flipper(PatchMesh& mesh, std::span<const LatticePoint> plane, std::span<const Point3> points,
          std::span<const RegionSegment> walls, const std::function<bool(int32_t, int32_t)>& may_join)
      : mesh_(mesh), plane_(plane), points_(points), may_join_(may_join) {
    for (const RegionSegment& s : walls) walls_.emplace_back(std::minmax(s.from, s.to));
    std::sort(walls_.begin(), walls_.end());
  }

  void Run() {
    for (const Face face : mesh_.all_faces()) {
      if (ShapeOf(face) < kPoorShape) FlipFrom(face);
    }
  }

 private:
  double Shape(int32_t a, int32_t b, int32_t c) const { return TriangleShape(points_[a], points_[b], points_[c]); }

  double ShapeOf(Face face) const {
    const auto [a, b, c] = mesh_.Corners(face);
    return Shape(a, b, c);
  }

  double CosineBetween(const Triangle& s, const Triangle& t) const {
    return TwiceVectorArea(points_, s).normalized().dot(TwiceVectorArea(points_, t).normalized());
  }

  bool Turns(int32_t a, int32_t b, int32_t c) const { return Orientation(plane_[a], plane_[b], plane_[c]) > 0; }

  bool Gains(HalfEdge e) const {
    const HalfEdge twin = mesh_.opposite_halfedge_handle(e);
    if (mesh_.is_boundary(twin)) return false;
    const int32_t a = mesh_.to_vertex_handle(twin).idx(), b = mesh_.to_vertex_handle(e).idx();
    const int32_t p = mesh_.Apex(e), q = mesh_.Apex(twin);
    if (!Turns(p, a, q) || !Turns(q, b, p)) return false;
    const double before = std::min(ShapeOf(mesh_.face_handle(e)), ShapeOf(mesh_.face_handle(twin)));
    return std::min(Shape(p, a, q), Shape(q, b, p)) > before + kLeastGain &&
           CosineBetween({p, a, q}, {q, b, p}) >= CosineBetween({p, a, b}, {q, b, a}) - kLargestCosineLoss &&
           !std::binary_search(walls_.begin(), walls_.end(), std::pair<int32_t, int32_t>(std::minmax(a, b))) &&
           may_join_(p, q) && mesh_.is_flip_ok(mesh_.edge_handle(e));
  }

  // Flips what gains around a triangle, then around what that changed.
  void FlipFrom(Face first) {
    todo_.assign(1, first);
    while (!todo_.empty()) {
      const Face face = todo_.back();
      todo_.pop_back();
      const HalfEdge start = mesh_.halfedge_handle(face);
      for (const HalfEdge e : {mesh_.next_halfedge_handle(start), mesh_.prev_halfedge_handle(start), start}) {
        if (!Gains(e)) continue;
        const Face other = mesh_.opposite_face_handle(e);
        mesh_.FlipEdge(mesh_.edge_handle(e));
        todo_.insert(todo_.end(), {face, other});
        break;
      }
    }
  }

  PatchMesh& mesh_;
  std::span<const LatticePoint> plane_;
  std::span<const Point3> points_;
  const std::function<bool(int32_t, int32_t)>& may_join_;
  std::vector<std::pair<int32_t, int32_t>> walls_;
  std::vector<Face> todo_;
};

}  // namespace

std::vector<Triangle> FlipForShape(const std::vector<Triangle>& triangles, std::span<const LatticePoint> plane,
                                   std::span<const Point3> points, std::span<const RegionSegment> walls,
                                   const std::function<bool(int32_t, int32_t)>& may_join) {
  PatchMesh mesh(points.first(plane.size()), triangles);
  if (!mesh.IsManifold()) return triangles;
  Flipper(mesh, plane, points, walls, may_join).Run();
  return mesh.Triangles();
}

}  // namespace tilemend
