#include "worker/papers/front/cotangent_system.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

using Eigen::MatrixXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;

constexpr double kMostCotangent = 100;

}  // namespace

Eigen::Vector3d HalfCotangents(const SpaceTriangle& t) {
  Eigen::Vector3d halves;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d u = t[(k + 1) % 3] - t[k], v = t[(k + 2) % 3] - t[k];
    const double cross = u.cross(v).norm(), dot = u.dot(v);
    const double most = dot < 0 ? -kMostCotangent : kMostCotangent;
    halves[k] = (cross * kMostCotangent > std::abs(dot) ? dot / cross : most) / 2;
  }
  return halves;
}

Eigen::Vector3d MixedAreas(const SpaceTriangle& t) {
  const Eigen::Vector3d halves = HalfCotangents(t);
  const double area = TwiceVectorArea(t).norm() / 2;
  Eigen::Vector3d areas;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    areas[k] = (halves[b] * (t[a] - t[k]).squaredNorm() + halves[a] * (t[b] - t[k]).squaredNorm()) / 4;
  }
  if (halves.minCoeff() >= 0) return areas;
  for (int k = 0; k < 3; ++k) areas[k] = halves[k] < 0 ? area / 2 : area / 4;
  return areas;
}

CotangentSystem::CotangentSystem(std::span<const Point3> points, std::span<const Triangle> triangles, int32_t rim)
    : rim_(rim) {
  const auto all = static_cast<int32_t>(points.size()), free = all - rim;
  std::vector<Triplet> halves;
  for (const Triangle& t : triangles) {
    const Eigen::Vector3d cotangents = HalfCotangents({points[t[0]], points[t[1]], points[t[2]]});
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      halves.emplace_back(std::min(a, b), std::max(a, b), cotangents[k]);
    }
  }
  SparseMatrix edges(all, all), operator_of_free(free, free);
  edges.setFromTriplets(halves.begin(), halves.end());
  weights_.assign(free, 0);
  std::vector<Triplet> inside, outside;
  const auto add = [&](int32_t from, int32_t to, double weight) {
    if (from < rim) return;
    weights_[from - rim] += weight;
    if (to < rim) {
      outside.emplace_back(from - rim, to, weight);
    } else {
      inside.emplace_back(from - rim, to - rim, -weight);
    }
  };
  for (int32_t column = 0; column < edges.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator it(edges, column); it; ++it) {
      add(static_cast<int32_t>(it.row()), column, it.value());
      add(column, static_cast<int32_t>(it.row()), it.value());
    }
  }
  for (int32_t v = 0; v < free; ++v) inside.emplace_back(v, v, weights_[v]);
  operator_of_free.setFromTriplets(inside.begin(), inside.end());
  to_rim_.resize(free, rim);
  to_rim_.setFromTriplets(outside.begin(), outside.end());
  solver_.compute(operator_of_free);
  ok_ = solver_.info() == Eigen::Success;
}

MatrixXd CotangentSystem::Solve(const MatrixXd& of_rim, const MatrixXd& right) const {
  return solver_.solve(to_rim_ * of_rim - right);
}

}  // namespace tilemend
