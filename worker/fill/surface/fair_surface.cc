#include "worker/fill/surface/fair_surface.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>

namespace tilemend {
namespace {

// Needles are given the area of a triangle with this sine, so that they cannot outweigh everything else.
constexpr double kLeastSine = 1e-3;

class BendingSystem {
 public:
  explicit BendingSystem(const FairSurfaceProblem& problem)
      : problem_(problem), row_(problem.points.size(), -1), column_(row_) {
    for (size_t v = 0; v < problem.points.size(); ++v) {
      if (problem.has_equation[v]) row_[v] = rows_++;
      if (!problem.known[v]) column_[v] = columns_++;
    }
    mass_ = Eigen::VectorXd::Zero(rows_);
    fixed_ = Eigen::MatrixXd::Zero(rows_, 3);
  }

  // Adds a triangle with the shape that its corners have in `shape`.
  void Add(const Triangle& t, const std::vector<Point3>& shape) {
    double longest2 = 0;
    for (int k = 0; k < 3; ++k) longest2 = std::max(longest2, (shape[t[(k + 1) % 3]] - shape[t[k]]).squaredNorm());
    const double area2 =
        std::max((shape[t[1]] - shape[t[0]]).cross(shape[t[2]] - shape[t[0]]).norm(), kLeastSine * longest2);
    for (int k = 0; k < 3; ++k) {
      const int32_t o = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      if (row_[o] >= 0) mass_[row_[o]] += area2 / 6;
      const double weight = (shape[a] - shape[o]).dot(shape[b] - shape[o]) / area2 / 2;  // half the cotangent at o
      AddEdge(a, b, weight);
      AddEdge(b, a, weight);
    }
  }

  bool Solve(std::vector<Point3>& points) const {
    Eigen::SparseMatrix<double> laplacian(rows_, columns_);
    laplacian.setFromTriplets(entries_.begin(), entries_.end());
    Eigen::SparseMatrix<double> scaled = laplacian;
    const Eigen::VectorXd inverse = mass_.cwiseInverse();
    for (int32_t column = 0; column < columns_; ++column) {
      for (Eigen::SparseMatrix<double>::InnerIterator it(scaled, column); it; ++it) it.valueRef() *= inverse[it.row()];
    }
    const Eigen::SparseMatrix<double> system = laplacian.transpose() * scaled;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
    if (solver.info() != Eigen::Success) return false;
    const Eigen::MatrixXd found = solver.solve(Eigen::MatrixXd(-(scaled.transpose() * fixed_)));
    if (solver.info() != Eigen::Success || !found.allFinite()) return false;
    for (size_t v = 0; v < column_.size(); ++v) {
      if (column_[v] >= 0) points[v] = found.row(column_[v]);
    }
    return true;
  }

 private:
  // The share of edge ab in the Laplacian at a.
  void AddEdge(int32_t a, int32_t b, double weight) {
    if (row_[a] < 0) return;
    AddTerm(row_[a], b, weight);
    AddTerm(row_[a], a, -weight);
  }

  void AddTerm(int32_t row, int32_t v, double weight) {
    if (column_[v] >= 0) {
      entries_.emplace_back(row, column_[v], weight);
    } else {
      fixed_.row(row) += weight * problem_.points[v].transpose();
    }
  }

  const FairSurfaceProblem& problem_;
  std::vector<int32_t> row_, column_;
  int32_t rows_ = 0, columns_ = 0;
  Eigen::VectorXd mass_;
  Eigen::MatrixXd fixed_;
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace

bool FairSurface(const std::vector<Point3>& shape, FairSurfaceProblem& problem) {
  if (std::find(problem.known.begin(), problem.known.end(), false) == problem.known.end()) return true;
  std::vector<Point3> points = problem.points;
  for (int solve = 0; solve < problem.solves; ++solve) {
    BendingSystem system(problem);
    for (const Triangle& t : problem.patch) system.Add(t, solve == 0 ? shape : points);
    for (const Triangle& t : problem.band) system.Add(t, points);
    if (!system.Solve(points)) return false;
  }
  problem.points = std::move(points);
  return true;
}

}  // namespace tilemend
