#include "worker/fill/shape/refine_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "common/mesh/exact_signs.h"
#include "worker/fill/mesh/patch_mesh.h"
#include "worker/fill/shape/spaced_points.h"

namespace tilemend {
namespace {

// Opposite angles of less than this beyond a half turn together are no reason to turn an edge: rounding would do it.
constexpr double kAngleSlack = 1e-6;
// Rounds of new points; each halves edges, so that more are never needed.
constexpr int kMostRounds = 40;
// Passes over all edges after a round. What they leave, the next round takes up.
constexpr int kTurnPasses = 12;

class Refiner {
 public:
  using HalfEdge = PatchMesh::HalfedgeHandle;

  Refiner(const RefineOptions& options, const std::function<bool(int32_t, int32_t)>& may_join, NewPatch& patch)
      : options_(options), may_join_(may_join), patch_(patch), mesh_(patch.points, patch.triangles) {
    double sum = 0;
    for (int32_t v = 0; v < patch.rim_count; ++v) sum += patch.sizes[v];
    largest_ = options.size_limit * sum / std::max(patch.rim_count, 1);
  }

  void Run() {
    if (!mesh_.IsManifold()) return;
    SplitForbiddenEdges();
    TurnEdges();
    for (int round = 0; round < kMostRounds && !options_.cancelled() && SplitTriangles(); ++round) TurnEdges();
    patch_.triangles = mesh_.Triangles();
  }

 private:
  void SplitForbiddenEdges() {
    const auto edges = static_cast<int>(mesh_.n_edges());
    for (int e = 0; e < edges; ++e) {
      const PatchMesh::EdgeHandle edge(e);
      const HalfEdge half = mesh_.halfedge_handle(edge, 0);
      const int32_t a = mesh_.from_vertex_handle(half).idx(), b = mesh_.to_vertex_handle(half).idx();
      if (mesh_.is_boundary(edge) || may_join_(a, b)) continue;
      const Point3 middle = (patch_.points[a] + patch_.points[b]) / 2;
      mesh_.split(edge, AddPoint(middle, (patch_.sizes[a] + patch_.sizes[b]) / 2));  // before any edge is settled
    }
  }

  PatchMesh::VertexHandle AddPoint(const Point3& p, double size) {
    patch_.points.push_back(p);
    patch_.sizes.push_back(size);
    return mesh_.add_vertex(PatchMesh::Point(p.x(), p.y(), p.z()));
  }

  double SizeAt(const Point3& c, const Triangle& corners) const {
    const double growth = options_.uniform ? 0 : options_.gradation - 1;
    double sum = 0, least = largest_;
    for (const int32_t v : corners) {
      sum += patch_.sizes[v];
      least = std::min(least, patch_.sizes[v] + growth * (c - patch_.points[v]).norm());
    }
    return growth > 0 ? std::max(least, sum / 3) : sum / 3;
  }

  bool SplitTriangles() {
    const auto faces = static_cast<int>(mesh_.n_faces());
    bool any = false;
    round_.Clear();
    for (int f = 0; f < faces && patch_.size() - patch_.rim_count < options_.max_new_points; ++f) {
      any |= Split(PatchMesh::FaceHandle(f));
    }
    return any;
  }

  bool Split(PatchMesh::FaceHandle face) {
    const Triangle corners = mesh_.Corners(face);
    if (patch_.LiesInStrip(corners)) return false;
    const auto at = [&](int32_t v) { return patch_.points[v]; };
    const Point3 c = (at(corners[0]) + at(corners[1]) + at(corners[2])) / 3;
    const double size = SizeAt(c, corners);
    for (const int32_t v : corners) {
      const double reach = std::numbers::sqrt2 * (c - at(v)).norm();
      if (reach <= size || reach <= patch_.sizes[v]) return false;
    }
    if (patch_.projects && !HasPlace(c, corners)) return false;
    if (patch_.spreads && round_.HasNear(c, size)) return true;  // the next round sees
    const PatchMesh::VertexHandle middle = AddPoint(c, size);
    if (patch_.spreads) round_.Add(c, size);
    mesh_.split(face, middle);
    for (const auto part : mesh_.vf_range(middle)) MarkStale(part);
    return true;
  }

  // Whether a point has all three sides of a triangle on its left, and none too close.
  bool HasPlace(const Point3& c, const Triangle& t) const {
    return IsHighEnough(c, t[0], t[1]) && IsHighEnough(c, t[1], t[2]) && IsHighEnough(c, t[2], t[0]);
  }

  // Whether the triangle turns left on the plane and is not too flat there.
  bool IsHighEnough(const Point3& p, int32_t a, int32_t b) const {
    const Point2 at = p.head<2>(), from = patch_.points[a].head<2>(), to = patch_.points[b].head<2>();
    if (TurnOf(at, from, to) <= 0) return false;
    const Point2 u = from - at, v = to - at;
    const double longest2 = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
    return u.x() * v.y() - u.y() * v.x() >= patch_.least_height * std::sqrt(longest2);
  }

  // An edge that was not to be turned is looked at again only when something about it has changed.
  void TurnEdges() {
    for (int pass = 0; pass < kTurnPasses; ++pass) {
      bool any = false;
      for (const auto edge : mesh_.edges()) {
        if (!IsStale(edge) || !IsBetterTurned(edge)) continue;
        mesh_.FlipEdge(edge);
        for (const int side : {0, 1}) MarkStale(mesh_.face_handle(mesh_.halfedge_handle(edge, side)));
        any = true;
      }
      if (!any) return;
    }
  }

  bool IsStale(PatchMesh::EdgeHandle edge) {
    settled_.resize(mesh_.n_edges(), false);
    return !settled_[edge.idx()];
  }

  void MarkStale(PatchMesh::FaceHandle face) {
    settled_.resize(mesh_.n_edges(), false);
    for (const auto edge : mesh_.fe_range(face)) settled_[edge.idx()] = false;
  }

  double AngleAt(int32_t apex, int32_t a, int32_t b) const {
    const Eigen::Vector3d u = patch_.points[a] - patch_.points[apex], v = patch_.points[b] - patch_.points[apex];
    return std::atan2(u.cross(v).norm(), u.dot(v));
  }

  bool IsBetterTurned(PatchMesh::EdgeHandle edge) {
    if (!IsBetterAcross(edge)) {
      settled_[edge.idx()] = true;
      return false;
    }
    return mesh_.is_flip_ok(edge);
  }

  // By its two triangles alone.
  bool IsBetterAcross(PatchMesh::EdgeHandle edge) const {
    if (mesh_.is_boundary(edge)) return false;
    const HalfEdge e = mesh_.halfedge_handle(edge, 0), twin = mesh_.opposite_halfedge_handle(e);
    const int32_t a = mesh_.to_vertex_handle(twin).idx(), b = mesh_.to_vertex_handle(e).idx();
    if (std::binary_search(patch_.fixed_edges.begin(), patch_.fixed_edges.end(),
                           std::pair(std::min(a, b), std::max(a, b)))) {
      return false;
    }
    const int32_t p = mesh_.Apex(e), q = mesh_.Apex(twin);
    if (AngleAt(p, a, b) + AngleAt(q, a, b) <= std::numbers::pi + kAngleSlack) return false;
    if (p < patch_.rim_count && q < patch_.rim_count && !may_join_(p, q)) return false;
    return !patch_.projects || (IsHighEnough(patch_.points[p], a, q) && IsHighEnough(patch_.points[q], b, p));
  }

  const RefineOptions& options_;
  const std::function<bool(int32_t, int32_t)>& may_join_;
  NewPatch& patch_;
  PatchMesh mesh_;
  SpacedPoints round_;         // that this round has added
  std::vector<bool> settled_;  // by edge: not to be turned as its triangles are
  double largest_ = 0;
};

}  // namespace

void RefinePatch(const RefineOptions& options, const std::function<bool(int32_t, int32_t)>& may_join, NewPatch& patch) {
  Refiner(options, may_join, patch).Run();
}

}  // namespace tilemend
