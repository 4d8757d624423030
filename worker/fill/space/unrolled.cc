#include "worker/fill/space/unrolled.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "worker/fill/mesh/patch_mesh.h"

namespace tilemend {

using Eigen::Vector3d;

Unrolled::Unrolled(std::vector<Point3> positions, std::vector<Triangle> triangles)
    : positions_(std::move(positions)), triangles_(std::move(triangles)), flat_(positions_.size(), Point2::Zero()) {
  const PatchMesh mesh(positions_, triangles_);
  const Triangle& first = triangles_[0];
  flat_[first[1]] = {(positions_[first[1]] - positions_[first[0]]).norm(), 0};
  std::vector<PatchMesh::HalfedgeHandle> open = {mesh.halfedge_handle(PatchMesh::FaceHandle(0))};
  std::vector<bool> placed(mesh.n_faces(), false);
  placed[0] = true;
  for (size_t next = 0; next < open.size(); ++next) {
    Place(mesh.from_vertex_handle(open[next]).idx(), mesh.to_vertex_handle(open[next]).idx(), mesh.Apex(open[next]));
    for (const auto h : mesh.fh_range(mesh.face_handle(open[next]))) {
      const auto across = mesh.opposite_halfedge_handle(h);
      if (mesh.is_boundary(across) || placed[mesh.face_handle(across).idx()]) continue;
      placed[mesh.face_handle(across).idx()] = true;
      open.push_back(across);
    }
  }
}

Point3 Unrolled::Lift(const Point2& p) const {
  Vector3d best = Vector3d::Constant(-INFINITY);
  const Triangle* at = nullptr;
  for (const Triangle& t : triangles_) {
    const Vector3d weights = Weights(t, p);
    if (weights.minCoeff() <= best.minCoeff()) continue;
    best = weights;
    at = &t;
    if (best.minCoeff() >= 0) break;
  }
  return best[0] * positions_[(*at)[0]] + best[1] * positions_[(*at)[1]] + best[2] * positions_[(*at)[2]];
}

// Places c on the left of the edge from a to b, which has both its ends placed.
void Unrolled::Place(int32_t a, int32_t b, int32_t c) {
  const Vector3d edge = positions_[b] - positions_[a], side = positions_[c] - positions_[a];
  const Point2 along = (flat_[b] - flat_[a]).normalized(), left(-along.y(), along.x());
  flat_[c] = flat_[a] + side.dot(edge) / edge.norm() * along + side.cross(edge).norm() / edge.norm() * left;
}

Vector3d Unrolled::Weights(const Triangle& t, const Point2& p) const {
  const auto area = [](const Point2& u, const Point2& v) { return u.x() * v.y() - u.y() * v.x(); };
  const Point2 a = flat_[t[0]] - p, b = flat_[t[1]] - p, c = flat_[t[2]] - p;
  const Vector3d parts(area(b, c), area(c, a), area(a, b));
  return parts / parts.sum();
}

}  // namespace tilemend
