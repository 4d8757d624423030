#include "worker/papers/front/poisson_patch.h"

#include <Eigen/Geometry>

#include "common/mesh/triangle_shape.h"
#include "worker/papers/front/cotangent_system.h"

namespace tilemend {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

// Unit normals of all points: given at the rim, harmonic inside.
std::vector<Vector3d> HarmonicNormals(std::span<const Vector3d> rim_normals, std::span<const Triangle> triangles,
                                      std::span<const Point3> points, const CotangentSystem& system) {
  const auto rim = std::ssize(rim_normals), free = std::ssize(points) - rim;
  std::vector<Vector3d> normals(points.size(), Vector3d::Zero());
  for (const Triangle& t : triangles) {
    for (const int32_t v : t) normals[v] += TwiceVectorArea(points, t);
  }
  MatrixXd of_rim(rim, 3);
  for (Eigen::Index v = 0; v < rim; ++v) {
    if (rim_normals[v].norm() > 0) normals[v] = rim_normals[v];
    normals[v].normalize();
    of_rim.row(v) = normals[v].transpose();
  }
  const MatrixXd inside = system.Solve(of_rim, MatrixXd::Zero(free, 3));
  for (Eigen::Index v = 0; v < free; ++v) normals[rim + v] = Vector3d(inside.row(v).transpose()).normalized();
  return normals;
}

SpaceTriangle Turned(const SpaceTriangle& t, const Vector3d& to) {
  const Vector3d own = TwiceVectorArea(t).normalized();
  const Point3 middle = (t[0] + t[1] + t[2]) / 3;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(own, to);
  return {middle + turn * (t[0] - middle), middle + turn * (t[1] - middle), middle + turn * (t[2] - middle)};
}

}  // namespace

bool ShapeByNormals(std::span<const Vector3d> rim_normals, std::span<const Triangle> triangles,
                    std::vector<Point3>& points) {
  const auto rim = static_cast<int32_t>(rim_normals.size()), all = static_cast<int32_t>(points.size());
  if (rim == all) return true;
  const CotangentSystem system(points, triangles, rim);
  if (!system.ok()) return false;
  const std::vector<Vector3d> normals = HarmonicNormals(rim_normals, triangles, points, system);
  MatrixXd of_rim(rim, 3), right = MatrixXd::Zero(all - rim, 3);
  for (int32_t v = 0; v < rim; ++v) of_rim.row(v) = points[v].transpose();
  for (const Triangle& t : triangles) {
    const SpaceTriangle own = {points[t[0]], points[t[1]], points[t[2]]};
    const Vector3d cotangents = HalfCotangents(own);
    const Vector3d normal = normals[t[0]] + normals[t[1]] + normals[t[2]];
    const SpaceTriangle turned = normal.norm() > 0 ? Turned(own, normal.normalized()) : own;
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      const Vector3d edge = cotangents[k] * (turned[b] - turned[a]);
      if (t[a] >= rim) right.row(t[a] - rim) += edge.transpose();
      if (t[b] >= rim) right.row(t[b] - rim) -= edge.transpose();
    }
  }
  const MatrixXd places = system.Solve(of_rim, right);
  if (!places.allFinite()) return false;
  for (int32_t v = rim; v < all; ++v) points[v] = places.row(v - rim).transpose();
  return true;
}

}  // namespace tilemend
