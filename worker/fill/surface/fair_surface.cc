#include "worker/fill/surface/fair_surface.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

// Needles are given the area of a triangle with this sine, so that they cannot outweigh everything else.
constexpr double kLeastSine = 1e-3;
// Of the area of the shapes that triangles should keep: a surface within so much of it has these shapes, and one of
// less than so much has lost them.
constexpr double kSameArea = 0.01, kLeastArea = 0.85;
// Solves at most.
constexpr int kRounds = 3;

// Of a triangle: twice its area, and at each corner half the cotangent.
struct Weights {
  double area2 = 0;
  std::array<double, 3> half_cotangents{};
};

Weights WeightsOf(const Triangle& t, const std::vector<Point3>& shape) {
  double longest2 = 0;
  for (int k = 0; k < 3; ++k) longest2 = std::max(longest2, (shape[t[(k + 1) % 3]] - shape[t[k]]).squaredNorm());
  Weights weights;
  weights.area2 = std::max((shape[t[1]] - shape[t[0]]).cross(shape[t[2]] - shape[t[0]]).norm(), kLeastSine * longest2);
  for (int k = 0; k < 3; ++k) {
    const Point3& o = shape[t[k]];
    weights.half_cotangents[k] = (shape[t[(k + 1) % 3]] - o).dot(shape[t[(k + 2) % 3]] - o) / weights.area2 / 2;
  }
  return weights;
}

// Twice the mean curvature at the points of triangles, below zero where the surface bends away from its normal.
class CurvatureSums {
 public:
  explicit CurvatureSums(const std::vector<Point3>& points)
      : points_(points),
        bends_(points.size(), Point3::Zero()),
        normals_(bends_),
        mass_(points.size(), 0),
        open_(points.size(), 0) {}

  void Add(const std::vector<Triangle>& triangles) {
    for (const Triangle& t : triangles) {
      const Weights weights = WeightsOf(t, points_);
      const Point3 normal = TwiceVectorArea(points_, t);
      for (int k = 0; k < 3; ++k) {
        const int32_t o = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        const Point3 edge = weights.half_cotangents[k] * (points_[b] - points_[a]);
        bends_[a] += edge;
        bends_[b] -= edge;
        normals_[o] += normal;
        mass_[o] += weights.area2 / 6;
        open_[o] += a - b;
      }
    }
  }

  bool IsSurrounded(int32_t v) const { return open_[v] == 0; }
  double MassAt(int32_t v) const { return mass_[v]; }
  double At(int32_t v) const { return bends_[v].dot(normals_[v].normalized()) / mass_[v]; }

 private:
  const std::vector<Point3>& points_;
  std::vector<Point3> bends_, normals_;
  std::vector<double> mass_;
  std::vector<int64_t> open_;  // sums of the ends of edges: zero if they close around the point
};

using CurvatureBeside = std::vector<std::optional<double>>;

// Of the original surface at the outer points of the band; none where it ends there.
CurvatureBeside FindCurvatureBeside(const FairSurfaceProblem& problem) {
  CurvatureSums sums(problem.points);
  sums.Add(problem.band);
  sums.Add(problem.beyond);
  CurvatureBeside curvature(problem.points.size());
  for (const Triangle& t : problem.beyond) {
    for (const int32_t v : t) {
      if (sums.IsSurrounded(v)) curvature[v] = sums.At(v);
    }
  }
  return curvature;
}

// By how much the curvature at the rim differs from that at the next points outward, in the mean over the edges between
// them. 0 if none is known there.
double JumpAtRim(const FairSurfaceProblem& problem, const std::vector<Point3>& points, const CurvatureBeside& beside) {
  CurvatureSums sums(points);
  sums.Add(problem.patch);
  sums.Add(problem.band);
  double jumps = 0, mass = 0;
  const auto add = [&](int32_t rim, int32_t outer) {
    if (!problem.has_equation[rim] || !beside[outer]) return;
    jumps += sums.MassAt(rim) * std::abs(sums.At(rim) - *beside[outer]);
    mass += sums.MassAt(rim);
  };
  for (const Triangle& t : problem.band) {
    for (int k = 0; k < 3; ++k) {
      add(t[k], t[(k + 1) % 3]);
      add(t[(k + 1) % 3], t[k]);
    }
  }
  return mass > 0 ? jumps / mass : 0;
}

class BendingSystem {
 public:
  //   shape  of the patch triangles
  BendingSystem(const FairSurfaceProblem& problem, const std::vector<Point3>& shape)
      : problem_(problem), column_(problem.points.size(), -1) {
    row_ = column_;
    for (size_t v = 0; v < problem.points.size(); ++v) {
      if (problem.has_equation[v]) row_[v] = Count(v, rows_);
      if (!problem.known[v]) column_[v] = Count(v, columns_);
    }
    mass_ = Eigen::VectorXd::Zero(std::ssize(rows_));
    fixed_ = Eigen::MatrixXd::Zero(std::ssize(rows_), 3);
    for (const Triangle& t : problem.patch) Add(t, shape);
    for (const Triangle& t : problem.band) Add(t, problem.points);
  }

  bool Factorize() {
    laplacian_.resize(std::ssize(rows_), std::ssize(columns_));
    laplacian_.setFromTriplets(entries_.begin(), entries_.end());
    mass_ = mass_.cwiseInverse();
    Eigen::SparseMatrix<double> scaled = mass_.asDiagonal() * laplacian_;
    solver_.compute(laplacian_.transpose() * scaled);
    right_side_ = -(scaled.transpose() * fixed_);
    return solver_.info() == Eigen::Success;
  }

  // Fills in the unknown points.
  bool Solve(std::vector<Point3>& points) const { return SolveFor(right_side_, points); }

  // One step from points that are solved for towards a mean curvature with no other Laplacian than that of the surface
  // around.
  bool EvenCurvature(const CurvatureBeside& beside, std::vector<Point3>& points) const {
    const std::vector<Point3> normals = Normals(points);
    const Eigen::VectorXd curvature = CurvatureOf(points, normals);
    Eigen::MatrixXd step = Eigen::MatrixXd::Zero(std::ssize(columns_), 3);
    double bent = 0;  // the Laplacian of the curvature, all over the patch, as it is now
    for (int32_t k = 0; k < laplacian_.outerSize(); ++k) {
      const Point3& normal = normals[columns_[static_cast<size_t>(k)]];
      for (Eigen::SparseMatrix<double>::InnerIterator it(laplacian_, k); it; ++it) {
        const Point3& other = normals[rows_[static_cast<size_t>(it.row())]];
        step.row(k) += it.value() * curvature[it.row()] * (other - normal).transpose();
      }
      bent -= step.row(k).dot(normal);
    }
    if (!SolveFor(right_side_ + step, points)) return false;
    const double inflow = InflowOf(CurvatureOf(points, Normals(points)), beside);
    const double right = bent == 0 ? 0 : std::clamp(inflow / bent, 0.0, 1.0);
    return right == 0 || SolveFor(right_side_ + (1 - right) * step, points);
  }

 private:
  static int32_t Count(size_t v, std::vector<int32_t>& list) {
    list.push_back(static_cast<int32_t>(v));
    return static_cast<int32_t>(list.size()) - 1;
  }

  bool SolveFor(const Eigen::MatrixXd& right_side, std::vector<Point3>& points) const {
    const Eigen::MatrixXd found = solver_.solve(right_side);
    if (solver_.info() != Eigen::Success || !found.allFinite()) return false;
    for (size_t k = 0; k < columns_.size(); ++k) points[columns_[k]] = found.row(static_cast<Eigen::Index>(k));
    return true;
  }

  // Twice the mean curvature by row.
  Eigen::VectorXd CurvatureOf(const std::vector<Point3>& points, const std::vector<Point3>& normals) const {
    Eigen::MatrixXd found(std::ssize(columns_), 3);
    for (size_t k = 0; k < columns_.size(); ++k) found.row(static_cast<Eigen::Index>(k)) = points[columns_[k]];
    const Eigen::MatrixXd bends = mass_.asDiagonal() * (laplacian_ * found + fixed_);
    Eigen::VectorXd curvature(std::ssize(rows_));
    for (size_t r = 0; r < rows_.size(); ++r) {
      const auto row = static_cast<Eigen::Index>(r);
      curvature[row] = bends.row(row).dot(normals[rows_[r]]);
    }
    return curvature;
  }

  // How much curvature flows in across the rim, as far as it does so evenly.
  double InflowOf(const Eigen::VectorXd& curvature, const CurvatureBeside& beside) const {
    std::vector<double> flows(rows_.size(), 0);
    for (const Triangle& t : problem_.band) {
      const Weights weights = WeightsOf(t, problem_.points);
      for (int k = 0; k < 3; ++k) {
        for (const auto& [at, other] : {std::pair(t[(k + 1) % 3], t[(k + 2) % 3]), {t[(k + 2) % 3], t[(k + 1) % 3]}}) {
          if (row_[at] < 0 || !beside[other]) continue;
          flows[row_[at]] += weights.half_cotangents[k] * (*beside[other] - curvature[row_[at]]);
        }
      }
    }
    std::erase(flows, 0.0);
    if (flows.empty()) return 0;
    const double sum = std::accumulate(flows.begin(), flows.end(), 0.0);
    double variance = 0;  // of the sum, if each is off by as much as they differ
    for (const double flow : flows) variance += std::pow(flow - sum / static_cast<double>(flows.size()), 2);
    return sum == 0 ? 0 : sum * (sum * sum / (sum * sum + variance));
  }

  std::vector<Point3> Normals(const std::vector<Point3>& points) const {
    std::vector<Point3> normals(points.size(), Point3::Zero());
    for (const auto* triangles : {&problem_.patch, &problem_.band}) {
      for (const Triangle& t : *triangles) {
        const Point3 normal = TwiceVectorArea(points, t);
        for (const int32_t v : t) normals[v] += normal;
      }
    }
    for (Point3& normal : normals) normal.normalize();
    return normals;
  }

  // Adds a triangle with the shape that its corners have in `shape`.
  void Add(const Triangle& t, const std::vector<Point3>& shape) {
    const Weights weights = WeightsOf(t, shape);
    for (int k = 0; k < 3; ++k) {
      const int32_t o = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      if (row_[o] >= 0) mass_[row_[o]] += weights.area2 / 6;
      AddEdge(a, b, weights.half_cotangents[k]);
      AddEdge(b, a, weights.half_cotangents[k]);
    }
  }

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
  std::vector<int32_t> row_, column_;    // by point; -1: none
  std::vector<int32_t> rows_, columns_;  // points
  Eigen::VectorXd mass_;                 // its inverse, once factorised
  Eigen::MatrixXd fixed_, right_side_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> laplacian_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

// Whether a second solve, with the shapes of the surface found, may be nearer.
bool IsWorthASecond(const FairSurfaceProblem& problem, const std::vector<Point3>& shape,
                    const std::vector<Point3>& points) {
  double meant = 0, found = 0;
  for (const Triangle& t : problem.patch) {
    meant += TwiceVectorArea(shape, t).norm();
    found += TwiceVectorArea(points, t).norm();
  }
  return found > kLeastArea * meant && std::abs(found - meant) > kSameArea * meant;
}

bool SolveTwice(const std::vector<Point3>& shape, FairSurfaceProblem& problem) {
  std::vector<Point3> points = problem.points;
  for (const bool again : {false, true}) {
    const std::vector<Point3> first = points;
    BendingSystem system(problem, again ? first : shape);
    if (!system.Factorize() || !system.Solve(points)) return false;
  }
  problem.points = std::move(points);
  return true;
}

// Of the surfaces of least bending and of even curvature, each with the shapes of the one before, that whose curvature
// goes on best at the rim.
bool SolveEvenly(const std::vector<Point3>& shape, FairSurfaceProblem& problem) {
  const CurvatureBeside beside = FindCurvatureBeside(problem);
  std::vector<Point3> points = problem.points, best;
  double least = 0;
  const auto consider = [&] {
    const double jump = JumpAtRim(problem, points, beside);
    if (!best.empty() && jump > least) return;
    best = points;
    least = jump;
  };
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Point3> before = points;
    BendingSystem system(problem, round == 0 ? shape : before);
    if (!system.Factorize() || !system.Solve(points)) return false;
    consider();
    if (!system.EvenCurvature(beside, points)) return false;
    consider();
    if (round == 0 && !IsWorthASecond(problem, shape, points)) break;
  }
  problem.points = std::move(best);
  return true;
}

}  // namespace

bool FairSurface(const std::vector<Point3>& shape, FairSurfaceProblem& problem) {
  if (std::find(problem.known.begin(), problem.known.end(), false) == problem.known.end()) return true;
  return problem.evens_curvature ? SolveEvenly(shape, problem) : SolveTwice(shape, problem);
}

}  // namespace tilemend
