#include "worker/papers/front/curvature_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "common/mesh/triangle_shape.h"
#include "worker/fill/mesh/patch_mesh.h"
#include "worker/papers/front/cotangent_system.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

// Opposite angles of less than this beyond a half turn together are no reason to turn an edge: rounding would do it.
constexpr double kAngleSlack = 1e-6;
// Angles around a vertex that miss a full turn by less, radians, miss it by rounding: it is flat.
constexpr double kFlat_rad = 1e-9;
constexpr int kTurnPasses = 12;

struct Ring {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
};

// The patch with the surface at its rim.
Ring Together(const RimSurface& surface, const CurvaturePatch& patch) {
  Ring all{patch.points, patch.triangles};
  all.points.insert(all.points.end(), surface.points.begin() + patch.rim, surface.points.end());
  const auto shift = static_cast<int32_t>(patch.points.size()) - patch.rim;
  for (Triangle t : surface.triangles) {
    for (int32_t& v : t) v += v < patch.rim ? 0 : shift;
    all.triangles.push_back(t);
  }
  return all;
}

double AngleAt(const Point3& apex, const Point3& a, const Point3& b) {
  const Vector3d u = a - apex, v = b - apex;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

void TurnEdges(int32_t rim, const std::function<bool(int32_t, int32_t)>& may_join, PatchMesh& mesh) {
  const auto at = [&](int32_t v) { return mesh.Position(PatchMesh::VertexHandle(v)); };
  const auto is_better_turned = [&](PatchMesh::EdgeHandle edge) {
    if (mesh.is_boundary(edge) || !mesh.is_flip_ok(edge)) return false;
    const auto e = mesh.halfedge_handle(edge, 0), twin = mesh.halfedge_handle(edge, 1);
    const int32_t a = mesh.from_vertex_handle(e).idx(), b = mesh.to_vertex_handle(e).idx();
    const int32_t p = mesh.Apex(e), q = mesh.Apex(twin);
    if (AngleAt(at(p), at(a), at(b)) + AngleAt(at(q), at(a), at(b)) <= std::numbers::pi + kAngleSlack) return false;
    return p >= rim || q >= rim || may_join(p, q);
  };
  for (int pass = 0; pass < kTurnPasses; ++pass) {
    bool any = false;
    for (const auto edge : mesh.edges()) {
      if (!is_better_turned(edge)) continue;
      mesh.FlipEdge(edge);
      any = true;
    }
    if (!any) return;
  }
}

// Halves edges that are too curved. False if there is none.
bool HalveCurvedEdges(std::span<const double> curvatures, double most, double shortest, PatchMesh& mesh,
                      CurvaturePatch& patch) {
  const auto edges = static_cast<int>(mesh.n_edges());
  bool any = false;
  for (int e = 0; e < edges; ++e) {
    const PatchMesh::EdgeHandle edge(e);
    const auto half = mesh.halfedge_handle(edge, 0);
    const int32_t a = mesh.from_vertex_handle(half).idx(), b = mesh.to_vertex_handle(half).idx();
    if (mesh.is_boundary(edge) || !((curvatures[a] + curvatures[b]) / 2 > most)) continue;
    if ((patch.points[a] - patch.points[b]).norm() / 2 < shortest) continue;
    const Point3 middle = (patch.points[a] + patch.points[b]) / 2;
    patch.points.push_back(middle);
    mesh.split(edge, mesh.add_vertex(PatchMesh::Point(middle.x(), middle.y(), middle.z())));
    any = true;
  }
  return any;
}

void MoveToCentroids(const RimSurface& surface, int32_t steps, CurvaturePatch& patch) {
  Ring all = Together(surface, patch);
  const auto count = static_cast<int32_t>(patch.points.size());
  for (int32_t step = 0; step < steps; ++step) {
    std::vector<double> area(all.points.size(), 0), weight(all.points.size(), 0);
    std::vector<Vector3d> sum(all.points.size(), Vector3d::Zero());
    for (const Triangle& t : all.triangles) {
      for (const int32_t v : t) area[v] += TwiceVectorArea(all.points, t).norm();
    }
    for (const Triangle& t : all.triangles) {
      for (int k = 0; k < 3; ++k) {
        const int32_t v = t[k], w = t[(k + 1) % 3];
        sum[v] += area[w] * all.points[w];
        weight[v] += area[w];
      }
    }
    for (int32_t v = patch.rim; v < count; ++v) {
      if (weight[v] > 0) all.points[v] = sum[v] / weight[v];
    }
  }
  std::copy_n(all.points.begin(), count, patch.points.begin());
}

}  // namespace

std::vector<double> AbsoluteCurvatures(std::span<const Point3> points, std::span<const Triangle> triangles,
                                       size_t count) {
  std::vector<double> missing(points.size(), 2 * std::numbers::pi), area(points.size(), 0);
  for (const Triangle& t : triangles) {
    const SpaceTriangle corners = {points[t[0]], points[t[1]], points[t[2]]};
    const Vector3d areas = MixedAreas(corners);
    for (int k = 0; k < 3; ++k) {
      missing[t[k]] -= AngleAt(corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]);
      area[t[k]] += areas[k];
    }
  }
  std::vector<double> curvatures(count, 0);
  for (size_t v = 0; v < count; ++v) {
    if (area[v] > 0 && std::abs(missing[v]) > kFlat_rad) curvatures[v] = std::abs(missing[v]) / area[v];
  }
  return curvatures;
}

void RefineByCurvature(const RimSurface& surface, const FillerOptions& options,
                       const std::function<bool(int32_t, int32_t)>& may_join, CurvaturePatch& patch) {
  PatchMesh mesh(patch.points, patch.triangles);
  if (!mesh.IsManifold() || patch.rim == 0) return;
  double rim_edges = 0, count = 0, most = -1;
  for (const auto& [a, b] : mesh.BoundaryEdges()) {
    rim_edges += (patch.points[a] - patch.points[b]).norm();
    count += 1;
  }
  const double shortest = std::ldexp(rim_edges / std::max(count, 1.0), -options.halvings);
  for (int32_t round = 0; round < options.halvings; ++round) {
    const Ring all = Together(surface, patch);
    const std::vector<double> curvatures = AbsoluteCurvatures(all.points, all.triangles, patch.points.size());
    if (most < 0) most = std::accumulate(curvatures.begin(), curvatures.begin() + patch.rim, 0.0) / patch.rim;
    if (!HalveCurvedEdges(curvatures, most, shortest, mesh, patch)) break;
    TurnEdges(patch.rim, may_join, mesh);
    patch.triangles = mesh.Triangles();
  }
  TurnEdges(patch.rim, may_join, mesh);
  patch.triangles = mesh.Triangles();
  MoveToCentroids(surface, options.centroid_steps, patch);
}

}  // namespace tilemend
