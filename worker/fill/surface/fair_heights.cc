#include "worker/fill/surface/fair_heights.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "worker/fill/mesh/patch_mesh.h"

namespace tilemend {
namespace {

// Cotangents are kept within these, so that a needle in the band cannot outweigh everything else.
constexpr double kLeastWeight = 1e-3;
constexpr double kMostWeight = 1e3;

// The neighbours and theirs, each once in rising order, without v.
std::vector<int32_t> FirstAndSecondOf(const PatchMesh& mesh, PatchMesh::VertexHandle v) {
  std::vector<int32_t> all;
  for (const auto n : mesh.vv_range(v)) {
    all.push_back(n.idx());
    for (const auto second : mesh.vv_range(n)) all.push_back(second.idx());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::erase(all, v.idx());
  return all;
}

double PlanarDistance(const Point3& a, const Point3& b) { return std::max((a - b).head<2>().norm(), 1e-9); }

// Half the cotangents of the corners of a triangle in the plane.
std::array<double, 3> HalfCotangents(const Point3& a, const Point3& b, const Point3& c) {
  const std::array<const Point3*, 3> p = {&a, &b, &c};
  std::array<double, 3> result;
  for (int k = 0; k < 3; ++k) {
    const Point2 u = (*p[(k + 1) % 3] - *p[k]).head<2>(), v = (*p[(k + 2) % 3] - *p[k]).head<2>();
    const double area2 = std::abs(u.x() * v.y() - u.y() * v.x());
    result[k] = u.dot(v) / std::max(area2, 1e-12) / 2;
  }
  return result;
}

// The rows of the umbrella operator (eq. 2 times the sum of the weights) at the vertices that have an equation.
struct Umbrella {
  std::vector<int32_t> row;                  // of each vertex, or -1
  std::vector<double> diagonal;              // sum of the weights of each row
  std::vector<Eigen::Triplet<double>> free;  // rows x new vertices
  Eigen::VectorXd fixed;                     // per row: what the fixed heights add
};

class UmbrellaBuilder {
 public:
  explicit UmbrellaBuilder(const FairingProblem& problem) : problem_(problem) {}

  Umbrella Build() {
    Umbrella u;
    u.row.assign(problem_.points.size(), -1);
    int32_t rows = 0;
    for (int32_t v = 0; v < problem_.rim_count + problem_.new_count; ++v) {
      if (v >= problem_.rim_count || problem_.has_equation[v]) u.row[v] = rows++;
    }
    u.diagonal.assign(static_cast<size_t>(rows), 0.0);
    u.fixed = Eigen::VectorXd::Zero(rows);
    CollectWeights(u);
    MergeWeights();
    for (const Weight& w : weights_) AddWeight(w, u);
    for (int32_t v = 0; v < problem_.rim_count + problem_.new_count; ++v) {
      if (u.row[v] < 0) continue;
      AddTerm(u, u.row[v], v, -u.diagonal[u.row[v]]);
    }
    return u;
  }

 private:
  struct Weight {
    int32_t a, b;
    double value;
  };

  void CollectWeights(const Umbrella& u) {
    for (const auto* triangles : {&problem_.patch, &problem_.band}) {
      for (const Triangle& t : *triangles) {
        if (u.row[t[0]] < 0 && u.row[t[1]] < 0 && u.row[t[2]] < 0) continue;
        const auto cot = HalfCotangents(problem_.points[t[0]], problem_.points[t[1]], problem_.points[t[2]]);
        for (int k = 0; k < 3; ++k) {
          const int32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
          weights_.push_back({std::min(a, b), std::max(a, b), cot[k]});
        }
      }
    }
  }

  void MergeWeights() {
    std::stable_sort(weights_.begin(), weights_.end(),
                     [](const Weight& x, const Weight& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    size_t n = 0;
    for (size_t i = 0; i < weights_.size(); ++i) {
      if (n > 0 && weights_[n - 1].a == weights_[i].a && weights_[n - 1].b == weights_[i].b) {
        weights_[n - 1].value += weights_[i].value;
      } else {
        weights_[n++] = weights_[i];
      }
    }
    weights_.resize(n);
    for (Weight& w : weights_) w.value = std::clamp(w.value, kLeastWeight, kMostWeight);
  }

  void AddWeight(const Weight& w, Umbrella& u) const {
    for (const auto& [v, other] : {std::pair{w.a, w.b}, std::pair{w.b, w.a}}) {
      if (u.row[v] < 0) continue;
      u.diagonal[u.row[v]] += w.value;
      AddTerm(u, u.row[v], other, w.value);
    }
  }

  void AddTerm(Umbrella& u, int32_t row, int32_t vertex, double value) const {
    const int32_t column = vertex - problem_.rim_count;
    if (column >= 0 && column < problem_.new_count) {
      u.free.emplace_back(row, column, value);
    } else {
      u.fixed[row] += value * problem_.points[vertex].z();
    }
  }

  const FairingProblem& problem_;
  std::vector<Weight> weights_;
};

}  // namespace

void AdjustHeights(FairingProblem& problem) {
  const int32_t end = problem.rim_count + problem.new_count;
  const PatchMesh mesh(problem.points, problem.patch);
  std::vector<bool> placed(problem.points.size(), false);
  std::vector<int32_t> ring;
  for (int32_t v = 0; v < problem.rim_count; ++v) {
    placed[v] = true;
    ring.push_back(v);
  }
  while (!ring.empty()) {
    std::vector<int32_t> inner;
    std::vector<bool> waiting(static_cast<size_t>(end), false);
    for (const int32_t v : ring) {
      for (const auto n : mesh.vv_range(PatchMesh::VertexHandle(v))) {
        if (placed[n.idx()] || waiting[n.idx()]) continue;
        waiting[n.idx()] = true;
        inner.push_back(n.idx());
      }
    }
    std::sort(inner.begin(), inner.end());
    for (const int32_t v : inner) {
      double sum = 0, weights = 0;
      for (const int32_t n : FirstAndSecondOf(mesh, PatchMesh::VertexHandle(v))) {
        if (!placed[n]) continue;
        const double w = 1 / PlanarDistance(problem.points[v], problem.points[n]);
        sum += w * problem.points[n].z();
        weights += w;
      }
      problem.points[v].z() = sum / weights;
    }
    for (const int32_t v : inner) placed[v] = true;
    ring = std::move(inner);
  }
}

bool FairHeights(FairingProblem& problem) {
  if (problem.new_count == 0) return true;
  const Umbrella u = UmbrellaBuilder(problem).Build();
  const auto rows = static_cast<int32_t>(u.diagonal.size());
  Eigen::SparseMatrix<double> umbrella(rows, problem.new_count);
  umbrella.setFromTriplets(u.free.begin(), u.free.end());
  Eigen::VectorXd inverse(rows);
  for (int32_t r = 0; r < rows; ++r) inverse[r] = 1 / u.diagonal[r];
  const Eigen::SparseMatrix<double> scaled = inverse.asDiagonal() * umbrella;
  const Eigen::SparseMatrix<double> system = umbrella.transpose() * scaled;
  const Eigen::VectorXd right = -(scaled.transpose() * u.fixed);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
  if (solver.info() != Eigen::Success) return false;
  const Eigen::VectorXd heights = solver.solve(right);
  if (solver.info() != Eigen::Success || !heights.allFinite()) return false;
  for (int32_t k = 0; k < problem.new_count; ++k) problem.points[problem.rim_count + k].z() = heights[k];
  return true;
}

}  // namespace tilemend
