// The cotangent Laplace operator of a patch whose rim stays.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_COTANGENT_SYSTEM_H_
#define TILEMEND_WORKER_PAPERS_FRONT_COTANGENT_SYSTEM_H_

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Half the cotangents of the three angles of a triangle, each kept between -100 and 100.
Eigen::Vector3d HalfCotangents(const SpaceTriangle& t);

// What of a triangle's area counts to each corner: Voronoi where it is acute, else half at the obtuse corner (Meyer
// 2002).
Eigen::Vector3d MixedAreas(const SpaceTriangle& t);

// Of the points from `rim` on: sum over the neighbours of w_ij (f_j - f_i), with the weights of Xu 2014, eq. 3, halved.
// On the rim f is given (Dirichlet).
class CotangentSystem {
 public:
  // Sparse Cholesky, about O(n^1.5).
  CotangentSystem(std::span<const Point3> points, std::span<const Triangle> triangles, int32_t rim);

  // Whether the equations have a solution.
  bool ok() const { return ok_; }
  // The sum of the weights of a point from `rim` on.
  double WeightOf(int32_t point) const { return weights_[point - rim_]; }
  // f of the points from `rim` on, so that the operator gives `right` there. A column each.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& of_rim, const Eigen::MatrixXd& right) const;

 private:
  const int32_t rim_;
  bool ok_ = true;
  std::vector<double> weights_;
  Eigen::SparseMatrix<double> to_rim_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_COTANGENT_SYSTEM_H_
