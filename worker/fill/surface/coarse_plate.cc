#include "worker/fill/surface/coarse_plate.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "common/mesh/triangulation/region_triangulation.h"
#include "common/mesh/vertex_lists.h"

namespace tilemend {
namespace {

// Coarse points grow apart by this length per length away from the boundary. More saves coarse unknowns and costs
// iterations: measured best between 0.25 and 0.4.
constexpr double kSlope = 0.3;
// But not farther apart than this multiple of the mean boundary edge: the smoother knows nothing of longer waves.
constexpr double kLongest = 32;
// A point within this multiple of a coarse point's size is left out. Just below 1, so that the first ring is not.
constexpr double kCovered = 0.85;
// Quadratics reach this multiple of their point's size; at 1 the mean is over too few of them to be smooth.
constexpr double kReach = 1.4;
// Added to the squares of the second-order terms, in units of the size: fits with fewer than five neighbours.
constexpr double kDamping = 1e-3;

// The edges of a patch that one triangle has, with the patch on the left.
std::vector<RegionSegment> BoundaryOf(const std::vector<Triangle>& patch, const VertexLists& edges) {
  std::vector<RegionSegment> boundary;
  for (const Triangle& t : patch) {
    for (int k = 0; k < 3; ++k) {
      const int32_t from = t[k], to = t[(k + 1) % 3];
      if (std::ranges::find(edges.Of(to), from) == edges.Of(to).end()) boundary.push_back({from, to});
    }
  }
  return boundary;
}

Eigen::Matrix<double, 5, 1> QuadraticTerms(const Point2& d) {
  return {d.x(), d.y(), d.x() * d.x(), d.x() * d.y(), d.y() * d.y()};
}

// The weight of a quadratic at a place in units of its size, before weights are made to sum to one.
double WeightAt(const Point2& place) {
  const double fall = std::max(1 - place.squaredNorm() * (1 / (kReach * kReach)), 0.0);
  return fall * fall;
}

}  // namespace

class PlateCoarsener {
 public:
  explicit PlateCoarsener(const ThinPlateProblem& fine)
      : fine_(fine),
        edges_(EdgeEndsFrom(fine.patch, fine.points.size())),
        boundary_(BoundaryOf(fine.patch, edges_)),
        size_(fine.points.size(), 0),
        reached_(fine.points.size(), -1),
        coarse_{{}, PlateInterpolation(fine)} {}

  std::optional<CoarsePlate> Run() {
    SetSizes();
    Choose();
    if (chosen_.empty() || !Triangulate()) return std::nullopt;
    AddBand();
    StorePatches();
    StoreFits();
    return std::move(coarse_);
  }

 private:
  Point2 At(int32_t v) const { return fine_.points[v].head<2>(); }

  // Calls use(u, distance) for all points that can be reached from v along edges through points within `radius` of v.
  template <typename Use>
  void Flood(int32_t v, double radius, const Use& use) {
    flood_.assign(1, v);
    reached_[v] = v;
    for (size_t head = 0; head < flood_.size(); ++head) {
      const int32_t u = flood_[head];
      use(u);
      for (const int32_t next : edges_.Of(u)) {
        if (reached_[next] == v) continue;
        reached_[next] = v;
        if ((At(next) - At(v)).squaredNorm() < radius * radius) flood_.push_back(next);
      }
    }
  }

  // The mean length of the boundary edges at a boundary point, growing from there inward; order_ gets the points of the
  // patch from the boundary inward.
  void SetSizes() {
    std::vector<int32_t> count(size_.size(), 0);
    double sum = 0;
    for (const RegionSegment& s : boundary_) {
      const double length = (At(s.from) - At(s.to)).norm();
      sum += length;
      for (const int32_t v : {s.from, s.to}) {
        size_[v] += length;
        ++count[v];
      }
    }
    const double mean = sum / static_cast<double>(boundary_.size());
    for (size_t v = 0; v < size_.size(); ++v) {
      const bool inside = count[v] == 0;
      if (edges_.Of(static_cast<int32_t>(v)).empty() || (inside && !fine_.known[v])) continue;
      size_[v] = inside ? mean : size_[v] / count[v];
      order_.push_back(static_cast<int32_t>(v));
    }
    first_inner_ = order_.size();
    for (size_t head = 0; head < order_.size(); ++head) {
      const int32_t v = order_[head];
      for (const int32_t to : edges_.Of(v)) {
        const double size = std::min(size_[v] + kSlope * (At(v) - At(to)).norm(), kLongest * mean);
        if (size_[to] == 0) order_.push_back(to);
        if (size_[to] == 0 || size < size_[to]) size_[to] = size;
      }
    }
  }

  // Takes the points of the boundary and those of known height, and of the others, from the boundary inward, each that
  // no chosen one covers.
  void Choose() {
    number_.assign(size_.size(), -1);
    std::vector<bool> covered(size_.size(), false);
    for (size_t i = 0; i < order_.size(); ++i) {
      const int32_t v = order_[i];
      if (i >= first_inner_ && covered[v]) continue;
      number_[v] = static_cast<int32_t>(chosen_.size());
      chosen_.push_back(v);
      Flood(v, kCovered * size_[v], [&](int32_t u) { covered[u] = true; });
    }
    std::fill(reached_.begin(), reached_.end(), -1);
  }

  bool Triangulate() {
    Point2 lo = At(chosen_[0]), hi = lo;
    for (const int32_t v : chosen_) {
      lo = lo.cwiseMin(At(v));
      hi = hi.cwiseMax(At(v));
    }
    const LatticeWindow window(lo, hi);
    std::vector<LatticePoint> points;
    for (const int32_t v : chosen_) points.push_back(window.Round(At(v)));
    std::vector<RegionSegment> segments;
    for (const RegionSegment& s : boundary_) segments.push_back({number_[s.from], number_[s.to]});
    RegionTriangulation triangulation = TriangulateRegion(points, segments);
    if (!triangulation.conflicts.empty()) return false;
    coarse_.problem.patch = std::move(triangulation.triangles);
    coarse_.problem.tension = fine_.tension;
    for (const int32_t v : chosen_) AddPoint(v);
    return true;
  }

  void AddPoint(int32_t v) {
    ThinPlateProblem& problem = coarse_.problem;
    number_[v] = static_cast<int32_t>(problem.points.size());
    problem.points.push_back(fine_.points[v]);
    if (!fine_.along.empty()) problem.along.push_back(fine_.along[v]);
    problem.known.push_back(fine_.known[v]);
    problem.has_equation.push_back(fine_.has_equation[v]);
    if (!fine_.laplacian.empty()) problem.laplacian.push_back(fine_.laplacian[v]);
  }

  void AddBand() {
    for (const Triangle& t : fine_.band) {
      for (const int32_t v : t) {
        if (number_[v] < 0) AddPoint(v);
      }
      coarse_.problem.band.push_back({number_[t[0]], number_[t[1]], number_[t[2]]});
    }
  }

  // Where the quadratics stand and which fine points they reach.
  void StorePatches() {
    PlateInterpolation& result = coarse_.interpolation;
    result.coarse_count_ = static_cast<int32_t>(coarse_.problem.points.size());
    result.inverse_total_.assign(fine_.points.size(), 0);
    for (const int32_t v : chosen_) {
      result.patches_.push_back({At(v), 1 / size_[v], 0, static_cast<int32_t>(result.target_.size())});
      Flood(v, kReach * size_[v], [&](int32_t u) {
        if (fine_.known[u]) return;
        result.target_.push_back(u);
        result.inverse_total_[u] += static_cast<float>(WeightAt(result.Place(result.patches_.back(), u)));
      });
    }
    for (float& total : result.inverse_total_) total = total > 0 ? 1 / total : 0;
  }

  // Least squares, weighted by the inverse square of the distance.
  void StoreFits() {
    PlateInterpolation& result = coarse_.interpolation;
    std::vector<Triangle> triangles = coarse_.problem.patch;
    triangles.insert(triangles.end(), coarse_.problem.band.begin(), coarse_.problem.band.end());
    const VertexLists edges = EdgeEndsFrom(triangles, coarse_.problem.points.size());
    // The surface does not go on from a rim point without an equation to the band: that may be a wall.
    const auto goes_on = [&](size_t from, int32_t to) {
      return to < std::ssize(chosen_) || coarse_.problem.has_equation[from];
    };
    for (size_t i = 0; i < chosen_.size(); ++i) {
      auto& patch = result.patches_[i];
      patch.first_neighbor = static_cast<int32_t>(result.neighbor_.size());
      Eigen::Matrix<double, 5, 5> normal = Eigen::Vector<double, 5>(0, 0, 1, 1, 1).asDiagonal() * kDamping;
      Eigen::Matrix<double, 5, Eigen::Dynamic> right(5, edges.Of(static_cast<int32_t>(i)).size());
      for (const int32_t to : edges.Of(static_cast<int32_t>(i))) {
        if (!goes_on(i, to)) continue;
        const Point2 d = (coarse_.problem.points[to].head<2>() - patch.centre) * patch.inverse_size;
        const auto terms = QuadraticTerms(d);
        auto column = right.col(static_cast<int32_t>(result.neighbor_.size()) - patch.first_neighbor);
        column = terms / d.squaredNorm();
        normal += column * terms.transpose();
        result.neighbor_.push_back(to);
      }
      right.conservativeResize(Eigen::NoChange, std::ssize(result.neighbor_) - patch.first_neighbor);
      right = normal.ldlt().solve(right).eval();
      for (const auto& column : right.colwise()) result.fit_.emplace_back(column.cast<float>());
    }
    result.patches_.push_back({Point2::Zero(), 1, static_cast<int32_t>(result.neighbor_.size()),
                               static_cast<int32_t>(result.target_.size())});
  }

  const ThinPlateProblem& fine_;
  const VertexLists edges_;  // of the patch: enough to reach every point of it from any other
  const std::vector<RegionSegment> boundary_;
  std::vector<double> size_;      // per fine point: the distance to the next coarse points that is wanted there
  std::vector<int32_t> order_;    // the points of the patch, from the boundary inward
  size_t first_inner_ = 0;        // in order_
  std::vector<int32_t> chosen_;   // the fine points of the coarse patch
  std::vector<int32_t> number_;   // per fine point: the coarse one
  std::vector<int32_t> reached_;  // per fine point: by which flood
  std::vector<int32_t> flood_;
  CoarsePlate coarse_;
};

Point2 PlateInterpolation::Place(const Patch& patch, int32_t fine) const {
  const Point3& p = fine_->points[fine];
  return {(p.x() - patch.centre.x()) * patch.inverse_size, (p.y() - patch.centre.y()) * patch.inverse_size};
}

PointValues PlateInterpolation::ToFine(const PointValues& coarse) const {
  PointValues result = PointValues::Zero(static_cast<Eigen::Index>(inverse_total_.size()));
  for (size_t i = 0; i + 1 < patches_.size(); ++i) {
    const Patch &patch = patches_[i], &end = patches_[i + 1];
    const double value = coarse[static_cast<int32_t>(i)];
    Terms f = Terms::Zero();
    for (int32_t k = patch.first_neighbor; k < end.first_neighbor; ++k) {
      f += (coarse[neighbor_[k]] - value) * fit_[k].cast<double>();
    }
    for (int32_t k = patch.first_target; k < end.first_target; ++k) {
      const Point2 place = Place(patch, target_[k]);
      result[target_[k]] += WeightAt(place) * inverse_total_[target_[k]] * (value + f.dot(QuadraticTerms(place)));
    }
  }
  return result;
}

PointValues PlateInterpolation::ToCoarse(const PointValues& fine) const {
  PointValues result = PointValues::Zero(coarse_count_);
  for (size_t i = 0; i + 1 < patches_.size(); ++i) {
    const Patch &patch = patches_[i], &end = patches_[i + 1];
    double value = 0;
    Terms f = Terms::Zero();
    for (int32_t k = patch.first_target; k < end.first_target; ++k) {
      const Point2 place = Place(patch, target_[k]);
      const double share = WeightAt(place) * inverse_total_[target_[k]] * fine[target_[k]];
      value += share;
      f += share * QuadraticTerms(place);
    }
    for (int32_t k = patch.first_neighbor; k < end.first_neighbor; ++k) {
      const double share = f.dot(fit_[k].cast<double>());
      result[neighbor_[k]] += share;
      value -= share;
    }
    result[static_cast<int32_t>(i)] += value;
  }
  return result;
}

std::optional<CoarsePlate> CoarsenPlate(const ThinPlateProblem& problem) { return PlateCoarsener(problem).Run(); }

}  // namespace tilemend
