#include "worker/fill/thin_plate.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace tilemend {
namespace {

// Needles in the band are given the area of a triangle with this angle, so that they cannot outweigh everything else.
constexpr double kLeastSine = 1e-3;

// Stiffness of one triangle and its area, in the plane.
struct Element {
  std::array<double, 3> half_cotangent;  // of the angle at each corner
  double area;
};

Element ElementOf(const Point3& a, const Point3& b, const Point3& c) {
  const std::array<Point2, 3> p = {a.head<2>(), b.head<2>(), c.head<2>()};
  Element e;
  double longest2 = 0;
  for (int k = 0; k < 3; ++k) longest2 = std::max(longest2, (p[(k + 1) % 3] - p[k]).squaredNorm());
  const Point2 u = p[1] - p[0], v = p[2] - p[0];
  const double area2 = std::max(std::abs(u.x() * v.y() - u.y() * v.x()), kLeastSine * longest2);
  e.area = area2 / 2;
  for (int k = 0; k < 3; ++k) {
    const Point2 s = p[(k + 1) % 3] - p[k], t = p[(k + 2) % 3] - p[k];
    e.half_cotangent[k] = s.dot(t) / area2 / 2;
  }
  return e;
}

class ThinPlateSystem {
 public:
  ThinPlateSystem(ThinPlateProblem& problem, bool bends, double tension)
      : problem_(problem), bends_(bends), taut_(tension), row_(problem.points.size(), -1), column_(row_) {
    for (size_t v = 0; v < problem.points.size(); ++v) {
      if (bends && problem.full_ring[v]) row_[v] = rows_++;
      if (!problem.known[v]) column_[v] = columns_++;
    }
    mass_ = Eigen::VectorXd::Zero(rows_);
    fixed_ = Eigen::VectorXd::Zero(rows_);
    right_ = Eigen::VectorXd::Zero(columns_);
  }

  std::optional<std::vector<double>> Solve() {
    Assemble();
    Eigen::SparseMatrix<double> stiffness(rows_, columns_);
    stiffness.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::VectorXd inverse = mass_.cwiseInverse();
    const Eigen::SparseMatrix<double> scaled = inverse.asDiagonal() * stiffness;
    Eigen::SparseMatrix<double> system = stiffness.transpose() * scaled;
    right_ -= scaled.transpose() * fixed_;
    if (taut_ > 0) {
      Eigen::SparseMatrix<double> taut(columns_, columns_);
      taut.setFromTriplets(tension_.begin(), tension_.end());
      system += taut;
    }
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
    if (solver.info() != Eigen::Success) return std::nullopt;
    const Eigen::VectorXd heights = solver.solve(right_);
    if (solver.info() != Eigen::Success || !heights.allFinite()) return std::nullopt;
    for (size_t v = 0; v < column_.size(); ++v) {
      if (column_[v] >= 0) problem_.points[v].z() = heights[column_[v]];
    }
    const Eigen::VectorXd bending = inverse.asDiagonal() * (stiffness * heights + fixed_);
    std::vector<double> laplacian(problem_.points.size(), 0.0);
    for (size_t v = 0; v < row_.size(); ++v) {
      if (row_[v] >= 0) laplacian[v] = bending[row_[v]];
    }
    return laplacian;
  }

 private:
  void Assemble() {
    for (const Triangle& t : problem_.patch) Add(t, true);
    for (const Triangle& t : problem_.band) Add(t, false);
  }

  void Add(const Triangle& t, bool patch) {
    const Element e = ElementOf(problem_.points[t[0]], problem_.points[t[1]], problem_.points[t[2]]);
    for (const int32_t v : t) {
      if (row_[v] >= 0) mass_[row_[v]] += e.area / 3;
    }
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      const double w = e.half_cotangent[k];
      AddEdge(a, b, w, patch);
      AddEdge(b, a, w, patch);
    }
  }

  // The share of edge ab in the Laplacian at a, w (h_b - h_a), and, transposed, of the Laplacian at a in the equation
  // at b.
  void AddEdge(int32_t a, int32_t b, double w, bool patch) {
    if (row_[a] >= 0) {
      AddTerm(row_[a], b, w);
      AddTerm(row_[a], a, -w);
    } else if (bends_ && patch && !problem_.laplacian.empty() && problem_.laplacian[a]) {
      if (column_[b] >= 0) right_[column_[b]] -= w * *problem_.laplacian[a];
      if (column_[a] >= 0) right_[column_[a]] += w * *problem_.laplacian[a];
    }
    if (taut_ > 0 && patch && column_[a] >= 0) {
      const double s = taut_ * w;
      tension_.emplace_back(column_[a], column_[a], s);
      if (column_[b] >= 0) {
        tension_.emplace_back(column_[a], column_[b], -s);
      } else {
        right_[column_[a]] += s * problem_.points[b].z();
      }
    }
  }

  void AddTerm(int32_t row, int32_t v, double value) {
    if (column_[v] >= 0) {
      entries_.emplace_back(row, column_[v], value);
    } else {
      fixed_[row] += value * problem_.points[v].z();
    }
  }

  ThinPlateProblem& problem_;
  const bool bends_;
  const double taut_;
  std::vector<int32_t> row_, column_;
  int32_t rows_ = 0, columns_ = 0;
  Eigen::VectorXd mass_, fixed_, right_;
  std::vector<Eigen::Triplet<double>> entries_, tension_;
};

}  // namespace

bool SolveMembrane(ThinPlateProblem& problem) { return ThinPlateSystem(problem, false, 1.0).Solve().has_value(); }

std::optional<std::vector<double>> SolveThinPlate(ThinPlateProblem& problem) {
  if (std::find(problem.known.begin(), problem.known.end(), false) == problem.known.end()) {
    return std::vector<double>(problem.points.size(), 0.0);
  }
  return ThinPlateSystem(problem, true, problem.tension).Solve();
}

}  // namespace tilemend
