#include "worker/papers/wang/fair_patch.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <algorithm>
#include <utility>
#include <vector>

#include "worker/fill/surface/direct_solver.h"

namespace tilemend {
namespace {

// Weights of edges are kept within these, so that each point has neighbours and no needle outweighs all else.
constexpr double kLeastWeight = 1e-3;
constexpr double kMostWeight = 1e3;
// Triangles without area are given that of one with this sine.
constexpr double kLeastSine = 1e-6;

using SparseMatrix = Eigen::SparseMatrix<double>;

// Of the new points' places after a step.
struct Equations {
  SparseMatrix lower;  // triangle of a symmetric matrix
  Eigen::MatrixXd right;
};

// The umbrella operator, times the sum of the weights, at the points that have an equation.
class Umbrella {
 public:
  Umbrella(const NewPatch& patch, const PatchSurroundings& around) : patch_(patch), around_(around) {
    const int32_t all = patch.size() + static_cast<int32_t>(around.points.size());
    row_.assign(all, -1);
    int32_t rows = 0;
    for (int32_t v = 0; v < patch.size(); ++v) {
      if (v >= patch.rim_count || around.has_equation[v]) row_[v] = rows++;
    }
    weights_ = Eigen::VectorXd::Zero(rows);
    fixed_ = Eigen::MatrixXd::Zero(rows, 3);
    AddWeights(all);
  }

  Equations ForStep() const {
    const int32_t unknowns = patch_.size() - patch_.rim_count;
    SparseMatrix umbrella(weights_.size(), unknowns), mass(unknowns, unknowns);
    umbrella.setFromTriplets(free_.begin(), free_.end());
    const SparseMatrix scaled = weights_.cwiseInverse().asDiagonal() * umbrella;
    const Eigen::VectorXd own = weights_.tail(unknowns);
    mass.setIdentity();
    const SparseMatrix system =
        SparseMatrix(own.asDiagonal() * mass) + kFairingStep * SparseMatrix(umbrella.transpose() * scaled);
    Eigen::MatrixXd right = -kFairingStep * (scaled.transpose() * fixed_);
    for (int32_t k = 0; k < unknowns; ++k) right.row(k) += own[k] * patch_.points[patch_.rim_count + k].transpose();
    return {system.triangularView<Eigen::Lower>(), std::move(right)};
  }

 private:
  const Point3& At(int32_t v) const { return v < patch_.size() ? patch_.points[v] : around_.points[v - patch_.size()]; }

  void AddWeights(int32_t all) {
    std::vector<Eigen::Triplet<double>> halves;
    for (const auto* triangles : {&patch_.triangles, &around_.triangles}) {
      for (const Triangle& t : *triangles) {
        for (int k = 0; k < 3; ++k) {
          const int32_t a = std::min(t[(k + 1) % 3], t[(k + 2) % 3]), b = std::max(t[(k + 1) % 3], t[(k + 2) % 3]);
          if (row_[a] >= 0 || row_[b] >= 0) halves.emplace_back(a, b, HalfCotangent(At(t[k]), At(a), At(b)));
        }
      }
    }
    SparseMatrix edges(all, all);
    edges.setFromTriplets(halves.begin(), halves.end());
    for (int32_t column = 0; column < edges.outerSize(); ++column) {
      for (SparseMatrix::InnerIterator it(edges, column); it; ++it) {
        const double weight = std::clamp(it.value(), kLeastWeight, kMostWeight);
        AddEdge(static_cast<int32_t>(it.row()), column, weight);
        AddEdge(column, static_cast<int32_t>(it.row()), weight);
      }
    }
    for (int32_t v = patch_.rim_count; v < patch_.size(); ++v)
      free_.emplace_back(row_[v], Column(v), -weights_[row_[v]]);
    for (int32_t v = 0; v < patch_.rim_count; ++v) {
      if (row_[v] >= 0) fixed_.row(row_[v]) -= weights_[row_[v]] * At(v).transpose();
    }
  }

  static double HalfCotangent(const Point3& apex, const Point3& a, const Point3& b) {
    const Eigen::Vector3d u = a - apex, v = b - apex;
    return u.dot(v) / std::max(u.cross(v).norm(), kLeastSine * u.norm() * v.norm() + 1e-300) / 2;
  }

  int32_t Column(int32_t v) const { return v - patch_.rim_count; }

  void AddEdge(int32_t from, int32_t to, double weight) {
    const int32_t row = row_[from];
    if (row < 0) return;
    weights_[row] += weight;
    if (to >= patch_.rim_count && to < patch_.size()) {
      free_.emplace_back(row, Column(to), weight);
    } else {
      fixed_.row(row) += weight * At(to).transpose();
    }
  }

  const NewPatch& patch_;
  const PatchSurroundings& around_;
  std::vector<int32_t> row_;                  // of each point, or -1; those of the new points are the last
  Eigen::VectorXd weights_;                   // their sum, of each row
  std::vector<Eigen::Triplet<double>> free_;  // rows x new points
  Eigen::MatrixXd fixed_;                     // of each row: what points that stay add
};

}  // namespace

bool FairPatch(const PatchSurroundings& around, int32_t steps, NewPatch& patch,
               const std::function<bool()>& is_cancelled) {
  if (patch.size() == patch.rim_count) return true;
  PointMover mover(patch);
  EliminationOrder order;  // edges stay, so that it serves every step
  for (int32_t step = 0; step < steps; ++step) {
    if (is_cancelled && is_cancelled()) return false;
    Equations equations = Umbrella(patch, around).ForStep();
    if (step == 0) order = OrderOf(equations.lower);
    const SymmetricFactorization factorization(order, equations.lower, is_cancelled);
    if (!factorization.ok()) return false;
    const Eigen::MatrixXd places = factorization.Solve(equations.right);
    if (!places.allFinite()) return false;
    for (int32_t v = patch.rim_count; v < patch.size(); ++v) {
      mover.Move(v, places.row(v - patch.rim_count).transpose());
    }
  }
  return true;
}

}  // namespace tilemend
