#include "worker/fill/surface/walled_ground.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/triangle_shape.h"
#include "common/mesh/weighted_median.h"
#include "worker/fill/surface/direct_solver.h"
#include "worker/fill/surface/height_reach.h"
#include "worker/fill/surface/plate_element.h"

namespace tilemend {
namespace {

constexpr double kManyObjects = 0.05;   // of the rim's original vertices
constexpr double kMostSteepness = 0.1;  // rise / run, as GroundFilterOptions::slope: what is steeper is no ground to it
constexpr double kLeastSteepness = 0.02;
// What a square metre between a reading and the surface costs, where one of wall costs 1.
constexpr double kCostBelowReading = 0.25;  // the surface passes below the reading
constexpr double kCostAboveReading = 2;
constexpr int kMostRounds = 20;
constexpr double kSettled = 0.002;  // metres
constexpr double kLeastOff = 0.01;  // metres: heights are told no better
// In the first round, where nothing is known of the surface yet.
constexpr double kFirstOff = 0.1;  // metres
constexpr double kFirstCost = 0.5;

// Half the length of the edges at each point that only one triangle has, seen from above.
std::vector<double> EdgeLengths(const ThinPlateProblem& problem) {
  std::vector<std::pair<int32_t, int32_t>> edges;  // once for each triangle
  for (const Triangle& t : problem.patch) {
    for (int k = 0; k < 3; ++k) edges.emplace_back(std::minmax(t[k], t[(k + 1) % 3]));
  }
  std::ranges::sort(edges);
  std::vector<double> lengths(problem.points.size(), 0);
  for (size_t i = 0, next = 0; i < edges.size(); i = next) {
    while (next < edges.size() && edges[next] == edges[i]) ++next;
    if (next > i + 1) continue;
    const auto [a, b] = edges[i];
    const double half = (problem.points[a] - problem.points[b]).head<2>().norm() / 2;
    lengths[a] += half;
    lengths[b] += half;
  }
  return lengths;
}

bool IsCancelled(const ThinPlateProblem& problem) { return problem.is_cancelled && problem.is_cancelled(); }

class WalledGround {
  using Entries = std::vector<Eigen::Triplet<double>>;

 public:
  WalledGround(const std::vector<RimReading>& readings, const GroundTrend& trend, const ThinPlateProblem& problem)
      : problem_(problem), steepness_(trend.steepness), lengths_(EdgeLengths(problem)) {
    const size_t count = problem.points.size();
    std::vector<bool> at_patch(count, false);
    for (const Triangle& t : problem.patch) {
      elements_.push_back(PlateElementOf<Point2>(
          {problem.points[t[0]].head<2>(), problem.points[t[1]].head<2>(), problem.points[t[2]].head<2>()}));
      for (const int32_t v : t) at_patch[v] = true;
    }
    weights_.assign(elements_.size(), 1);
    const std::vector<bool> is_bound = BoundParts(readings);
    for (size_t v = 0; v < count; ++v) {
      heights_.push_back(problem.points[v].z() - trend.slope.dot(problem.points[v].head<2>()));
      const bool is_known = IsKnown(v, readings) || (!is_bound[v] && problem.known[v]);
      column_.push_back(at_patch[v] && !is_known ? unknowns_++ : -1);
      if (at_patch[v] && is_known) Bound(heights_[v]);
      if (column_[v] < 0 || v >= readings.size() || readings[v] != RimReading::kReading) continue;
      readings_.emplace_back(static_cast<int32_t>(v), heights_[v]);
      Bound(heights_[v]);
    }
  }

  // The heights of all points over the trend; none if they cannot be found.
  std::optional<std::vector<double>> Solve() {
    if (lowest_ > highest_) return std::nullopt;
    for (int round = 0; unknowns_ > 0 && round < kMostRounds; ++round) {
      if (IsCancelled(problem_)) return std::nullopt;
      const std::optional<double> moved = SolveRound(round == 0);
      if (!moved) return std::nullopt;
      if (round > 0 && *moved < kSettled) break;
      WeighTriangles();
    }
    // A membrane stays between what is known; what is solved for on triangles with obtuse angles need not.
    for (size_t v = 0; v < heights_.size(); ++v) {
      if (is_unknown(v)) heights_[v] = std::clamp(heights_[v], lowest_, highest_);
    }
    return heights_;
  }

  bool is_unknown(size_t v) const { return column_[v] >= 0; }

 private:
  bool IsKnown(size_t v, const std::vector<RimReading>& readings) const {
    return v < readings.size() ? readings[v] == RimReading::kFixed : static_cast<bool>(problem_.known[v]);
  }

  // Whether a point hangs together, through the patch, with any whose height is read or fixed. The rim of other parts
  // keeps the heights that it has.
  std::vector<bool> BoundParts(const std::vector<RimReading>& readings) const {
    DisjointSets parts(static_cast<int32_t>(problem_.points.size()));
    for (const Triangle& t : problem_.patch) {
      parts.Join(t[0], t[1]);
      parts.Join(t[0], t[2]);
    }
    std::vector<bool> is_bound(problem_.points.size(), false);  // by part
    for (const Triangle& t : problem_.patch) {
      for (const int32_t v : t) {
        const auto point = static_cast<size_t>(v);
        const bool is_reading = point < readings.size() && readings[point] == RimReading::kReading;
        if (is_reading || IsKnown(point, readings)) is_bound[parts.LowestOf(v)] = true;
      }
    }
    std::vector<bool> result(problem_.points.size());
    for (size_t v = 0; v < result.size(); ++v) result[v] = is_bound[parts.LowestOf(static_cast<int32_t>(v))];
    return result;
  }

  void Bound(double height) {
    lowest_ = std::min(lowest_, height);
    highest_ = std::max(highest_, height);
  }

  // How far the height that moves most has moved.
  std::optional<double> SolveRound(bool is_first) {
    Eigen::SparseMatrix<double> matrix = MakeEquations(is_first);
    if (IsCancelled(problem_)) return std::nullopt;
    if (is_first) order_ = OrderOf(matrix);
    const SymmetricFactorization factorization(order_, matrix, problem_.is_cancelled);
    if (!factorization.ok()) return std::nullopt;
    const Eigen::VectorXd found = factorization.Solve(right_);
    if (!found.allFinite()) return std::nullopt;
    double moved = 0;
    for (size_t v = 0; v < heights_.size(); ++v) {
      if (column_[v] < 0) continue;
      moved = std::max(moved, std::abs(heights_[v] - found[column_[v]]));
      heights_[v] = found[column_[v]];
    }
    return moved;
  }

  // The lower half of the matrix; sets the right side.
  Eigen::SparseMatrix<double> MakeEquations(bool is_first) {
    Entries entries;
    entries.reserve(9 * elements_.size());
    right_ = Eigen::VectorXd::Zero(unknowns_);
    for (size_t i = 0; i < elements_.size(); ++i) AddTriangle(i, entries);
    for (const auto& [v, height] : readings_) AddReading(v, height, is_first, entries);
    Eigen::SparseMatrix<double> matrix(unknowns_, unknowns_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  void AddTriangle(size_t i, Entries& entries) {
    const Triangle& t = problem_.patch[i];
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      const double weight = weights_[i] * elements_[i].half_cotangent[k];
      AddSide(a, b, weight, entries);
      AddSide(b, a, weight, entries);
    }
  }

  void AddSide(int32_t v, int32_t other, double weight, Entries& entries) {
    if (column_[v] < 0) return;
    entries.emplace_back(column_[v], column_[v], weight);
    if (column_[other] < 0) {
      right_[column_[v]] += weight * heights_[other];
    } else if (column_[v] > column_[other]) {
      entries.emplace_back(column_[v], column_[other], -weight);
    }
  }

  void AddReading(int32_t v, double height, bool is_first, Entries& entries) {
    const double above = height - heights_[v];
    const double cost = above > 0 ? kCostBelowReading : kCostAboveReading;
    const double off = std::max(std::abs(above), kLeastOff);
    const double weight = steepness_ * lengths_[v] * (is_first ? kFirstCost / kFirstOff : cost / off);
    entries.emplace_back(column_[v], column_[v], weight);
    right_[column_[v]] += weight * height;
  }

  // A triangle that is a wall gives way: its weight is that of the ground's steepness over its own.
  void WeighTriangles() {
    for (size_t i = 0; i < elements_.size(); ++i) {
      const Triangle& t = problem_.patch[i];
      double energy = 0;
      for (int k = 0; k < 3; ++k) {
        const double rise = heights_[t[(k + 1) % 3]] - heights_[t[(k + 2) % 3]];
        energy += elements_[i].half_cotangent[k] * rise * rise;
      }
      const double slope = std::sqrt(std::max(0.0, energy / elements_[i].area));
      weights_[i] = steepness_ / std::max(steepness_, slope);
    }
  }

  const ThinPlateProblem& problem_;
  const double steepness_;
  const std::vector<double> lengths_;
  std::vector<PlateElement> elements_;
  std::vector<double> weights_;                       // of the triangles
  std::vector<double> heights_;                       // of the points, over the trend
  std::vector<int32_t> column_;                       // of the points in the matrix; -1: known
  std::vector<std::pair<int32_t, double>> readings_;  // points and heights
  int32_t unknowns_ = 0;
  double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -lowest_;  // of what is known
  Eigen::VectorXd right_;
  EliminationOrder order_;
};

RimReading ReadingOf(const RimVertex& vertex) {
  if (vertex.on_object && !vertex.ground) return RimReading::kNothing;
  if (vertex.index < 0) return vertex.height_known ? RimReading::kFixed : RimReading::kNothing;
  return vertex.on_object || vertex.on_ground ? RimReading::kReading : RimReading::kFixed;
}

}  // namespace

GroundTrend TrendOf(const ThinPlateProblem& problem) {
  std::vector<std::pair<Point2, double>> slopes;  // and areas
  std::vector<std::pair<double, double>> x, y, beside;
  for (const Triangle& t : problem.band) {
    if (!IsGround(problem, t)) continue;
    const Eigen::Vector3d normal = TwiceVectorArea(problem.points, t);
    const Point2 slope = -normal.head<2>() / normal.z();
    slopes.emplace_back(slope, normal.z());
    x.emplace_back(slope.x(), normal.z());
    y.emplace_back(slope.y(), normal.z());
  }
  if (slopes.empty()) return {{0, 0}, kMostSteepness};
  const Point2 trend(*WeightedMedian(std::move(x)), *WeightedMedian(std::move(y)));
  for (const auto& [slope, area] : slopes) beside.emplace_back((slope - trend).norm(), area);
  return {trend, std::clamp(*WeightedMedian(std::move(beside)), kLeastSteepness, kMostSteepness)};
}

bool HasWalls(const LocalHole& hole, const HoldOut& chosen, const GroundTrend& trend) {
  int originals = 0, on_objects = 0;
  for (const int32_t v : hole.vertices) {
    if (v < 0 || hole.cell->vertices[v].index < 0) continue;
    ++originals;
    if (hole.cell->vertices[v].on_object) ++on_objects;
  }
  return on_objects > 0 && on_objects >= kManyObjects * originals && chosen.tension > 0 &&
         trend.slope.norm() <= kMostSteepness;
}

std::vector<RimReading> ReadingsOf(const LocalHole& hole) {
  std::vector<RimReading> readings;
  for (const int32_t v : hole.vertices) {
    readings.push_back(v < 0 ? RimReading::kNothing : ReadingOf(hole.cell->vertices[v]));
  }
  return readings;
}

std::vector<RimReading> SettledReadingsOf(const LocalHole& hole) {
  std::vector<RimReading> readings;
  for (const int32_t v : hole.vertices) {
    const bool is_settled = v >= 0 && hole.cell->vertices[v].ground.has_value();
    readings.push_back(v < 0        ? RimReading::kNothing
                       : is_settled ? RimReading::kFixed
                                    : ReadingOf(hole.cell->vertices[v]));
  }
  return readings;
}

bool SolveWalledGround(const std::vector<RimReading>& readings, const GroundTrend& trend, ThinPlateProblem& problem) {
  if (IsCancelled(problem)) return false;
  WalledGround ground(readings, trend, problem);
  const std::optional<std::vector<double>> heights = ground.Solve();
  if (!heights) return false;
  for (size_t v = 0; v < problem.points.size(); ++v) {
    if (!ground.is_unknown(v)) continue;
    problem.points[v].z() = (*heights)[v] + trend.slope.dot(problem.points[v].head<2>());
    problem.known[v] = true;
  }
  problem.band.clear();
  problem.has_equation.assign(problem.points.size(), false);
  return true;
}

}  // namespace tilemend
