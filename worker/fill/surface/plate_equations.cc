#include "worker/fill/surface/plate_equations.h"

#include <algorithm>
#include <utility>

#include "common/mesh/vertex_lists.h"
#include "worker/fill/surface/plate_element.h"

namespace tilemend {
namespace {

PlateElement ElementOf(const ThinPlateProblem& problem, const Triangle& t) {
  const std::vector<Point3>& p = problem.points;
  if (problem.along.empty()) return PlateElementOf<Point2>({p[t[0]].head<2>(), p[t[1]].head<2>(), p[t[2]].head<2>()});
  return PlateElementOf<Point3>({problem.along[t[0]], problem.along[t[1]], problem.along[t[2]]});
}

// The corners of all triangles at each point: corner 4 t + k is corner k of triangle t, the patch's before the band's.
VertexLists CornersOf(const ThinPlateProblem& problem) {
  return VertexLists(problem.points.size(), [&](const auto& use) {
    int32_t corner = 0;
    for (const auto* triangles : {&problem.patch, &problem.band}) {
      for (const Triangle& t : *triangles) {
        for (int k = 0; k < 3; ++k) use(t[k], corner + k);
        corner += 4;
      }
    }
  });
}

// Collects the points that v is joined with, twice where two triangles have the edge, each time with half a cotangent.
// Returns the mass at v.
double CollectRow(const ThinPlateProblem& problem, const VertexLists& corners, int32_t v,
                  std::vector<std::pair<int32_t, double>>& row) {
  const auto patch_count = static_cast<int32_t>(problem.patch.size());
  double mass = 0;
  row.clear();
  for (const int32_t c : corners.Of(v)) {
    const int32_t number = c >> 2, next = ((c & 3) + 1) % 3, last = ((c & 3) + 2) % 3;
    const Triangle& t = number < patch_count ? problem.patch[number] : problem.band[number - patch_count];
    const PlateElement e = ElementOf(problem, t);
    mass += e.area / 3;
    row.emplace_back(t[next], e.half_cotangent[last]);
    row.emplace_back(t[last], e.half_cotangent[next]);
  }
  std::sort(row.begin(), row.end());
  return mass;
}

}  // namespace

PlateEquations::PlateEquations(const ThinPlateProblem& problem, bool bends, double tension)
    : column_(problem.points.size(), -1), tension_(tension) {
  const auto count = static_cast<int32_t>(problem.points.size());
  diagonal_ = inverse_mass_ = given_ = Eigen::VectorXd::Zero(count);
  start_.assign(1, 0);
  const VertexLists corners = CornersOf(problem);
  std::vector<std::pair<int32_t, double>> row;
  for (int32_t v = 0; v < count; ++v) {
    const bool equation = bends && problem.has_equation[v];
    if (equation || !problem.known[v]) {
      const double mass = CollectRow(problem, corners, v, row);
      if (equation && mass > 0) inverse_mass_[v] = 1 / mass;
      StoreRow(v, row);
    }
    start_.push_back(static_cast<int32_t>(to_.size()));
    if (bends && !equation && !problem.laplacian.empty()) given_[v] = problem.laplacian[v].value_or(0);
    if (problem.known[v]) continue;
    column_[v] = unknown_count();
    unknown_.push_back(v);
  }
}

// Appends a sorted row, equal points as one.
void PlateEquations::StoreRow(int32_t v, const std::vector<std::pair<int32_t, double>>& row) {
  for (const auto& [to, weight] : row) {
    if (to_.size() > static_cast<size_t>(start_.back()) && to_.back() == to) {
      weight_.back() += weight;
    } else {
      to_.push_back(to);
      weight_.push_back(weight);
    }
    diagonal_[v] -= weight;
  }
}

// Row v of -K times x.
double PlateEquations::Row(int32_t v, const PointValues& x) const {
  double sum = diagonal_[v] * x[v];
  for (int32_t i = start_[v]; i < start_[v + 1]; ++i) sum += weight_[i] * x[to_[i]];
  return sum;
}

PointValues PlateEquations::Laplacians(const PointValues& heights) const {
  PointValues result = given_;
  for (int32_t v = 0; v < result.size(); ++v) {
    if (inverse_mass_[v] > 0) result[v] = inverse_mass_[v] * Row(v, heights);
  }
  return result;
}

// (K M^-1 K + tension K) x at the unknown points.
PointValues PlateEquations::Product(const PointValues& x, const PointValues& laplacians) const {
  PointValues result = PointValues::Zero(x.size());
  for (const int32_t v : unknown_) {
    result[v] = Row(v, laplacians);
    if (tension_ > 0) result[v] -= tension_ * Row(v, x);
  }
  return result;
}

PointValues PlateEquations::Residual(const PointValues& heights) const {
  return -Product(heights, Laplacians(heights));
}

PointValues PlateEquations::Apply(const PointValues& x) const {
  PointValues laplacians = PointValues::Zero(x.size());
  for (int32_t v = 0; v < x.size(); ++v) {
    if (inverse_mass_[v] > 0) laplacians[v] = inverse_mass_[v] * Row(v, x);
  }
  return Product(x, laplacians);
}

PointValues PlateEquations::Diagonal() const {
  PointValues result = PointValues::Ones(diagonal_.size());
  for (const int32_t v : unknown_) {
    result[v] = diagonal_[v] * diagonal_[v] * inverse_mass_[v] - tension_ * diagonal_[v];
    for (int32_t i = start_[v]; i < start_[v + 1]; ++i) {
      result[v] += weight_[i] * weight_[i] * inverse_mass_[to_[i]];
    }
  }
  return result;
}

double PlateEquations::Energy(const PointValues& heights) const {
  double energy = 0;
  for (int32_t v = 0; v < heights.size(); ++v) {
    const double row = inverse_mass_[v] > 0 ? Row(v, heights) : 0;
    energy += row * row * inverse_mass_[v];
  }
  for (const int32_t v : unknown_) {
    for (int32_t i = start_[v]; i < start_[v + 1]; ++i) {
      const double rise = heights[to_[i]] - heights[v];
      energy += tension_ * weight_[i] * rise * rise / 2;
    }
  }
  return energy;
}

// Column by column. K is symmetric, so that row v has column v of K as well.
Eigen::SparseMatrix<double> PlateEquations::LowerMatrix() const {
  Eigen::SparseMatrix<double> matrix(unknown_count(), unknown_count());
  matrix.reserve(static_cast<Eigen::Index>(2 * to_.size()));
  std::vector<double> value(unknown_.size());
  std::vector<int32_t> stored(unknown_.size(), -1);  // the column that `value` is of
  std::vector<int32_t> rows;
  for (int32_t column = 0; column < unknown_count(); ++column) {
    const auto add = [&](int32_t point, double more) {
      const int32_t row = column_[point];
      if (row < column) return;  // -1 is known
      if (stored[row] != column) {
        stored[row] = column;
        value[row] = 0;
        rows.push_back(row);
      }
      value[row] += more;
    };
    EachInRow(unknown_[column], [&](int32_t u, double weight) {
      if (inverse_mass_[u] <= 0) return;
      const double scaled = inverse_mass_[u] * weight;
      EachInRow(u, [&](int32_t point, double other) { add(point, other * scaled); });
    });
    if (tension_ > 0) {
      EachInRow(unknown_[column], [&](int32_t point, double weight) { add(point, -(tension_ * weight)); });
    }
    std::sort(rows.begin(), rows.end());
    matrix.startVec(column);
    for (const int32_t row : rows) matrix.insertBack(row, column) = value[row];
    rows.clear();
  }
  matrix.finalize();
  return matrix;
}

Eigen::VectorXd PlateEquations::Gather(const PointValues& values) const {
  Eigen::VectorXd result(unknown_count());
  for (int32_t i = 0; i < unknown_count(); ++i) result[i] = values[unknown_[i]];
  return result;
}

PointValues PlateEquations::Spread(const Eigen::VectorXd& unknown_only) const {
  PointValues result = PointValues::Zero(static_cast<Eigen::Index>(column_.size()));
  for (int32_t i = 0; i < unknown_count(); ++i) result[unknown_[i]] = unknown_only[i];
  return result;
}

}  // namespace tilemend
