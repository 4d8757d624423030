#include "coordinator/plan/water/shore_objects.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

namespace tilemend {
namespace {

constexpr int kSquaresPerRadius = 10;
constexpr double kTrendSquare = 2;    // radii
constexpr size_t kLeastForTrend = 6;  // lowest points: fewer are no trend
constexpr double kNear = 1e-3;        // metres: nearer points are as far
constexpr double kFlatSpread = 1e-2;  // of the smaller variance to the larger one: below it the points lie on a line

using Square = std::pair<int32_t, int32_t>;

Square SquareAt(const Point2& p, double size) {
  return {static_cast<int32_t>(std::floor(p.x() / size)), static_cast<int32_t>(std::floor(p.y() / size))};
}

// Heights less the plane through the lowest points of large squares.
class Trend {
 public:
  explicit Trend(std::span<const Point3> points, double square) {
    std::map<Square, Point3> lowest;
    for (const Point3& p : points) {
      const auto [it, fresh] = lowest.try_emplace(SquareAt(p.head<2>(), square), p);
      if (!fresh && p.z() < it->second.z()) it->second = p;
    }
    if (lowest.size() >= kLeastForTrend) Fit(lowest);
  }

  Point3 Without(const Point3& p) const { return {p.x(), p.y(), p.z() - slope_.dot(p.head<2>() - middle_)}; }

 private:
  void Fit(const std::map<Square, Point3>& lowest) {
    Point3 mean = Point3::Zero();
    for (const auto& [square, p] : lowest) mean += p / static_cast<double>(lowest.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    Eigen::Vector2d rise = Eigen::Vector2d::Zero();
    for (const auto& [square, p] : lowest) {
      const Point2 at = (p - mean).head<2>();
      spread += at * at.transpose();
      rise += at * (p.z() - mean.z());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
    for (int k = 0; k < 2; ++k) {
      if (axes.eigenvalues()[k] <= kFlatSpread * axes.eigenvalues()[1]) continue;
      const Eigen::Vector2d axis = axes.eigenvectors().col(k);
      slope_ += axis * (axis.dot(rise) / axes.eigenvalues()[k]);
    }
    middle_ = mean.head<2>();
  }

  Point2 middle_{0, 0};
  Eigen::Vector2d slope_ = Eigen::Vector2d::Zero();
};

// The lowest height of every small square that has a point, and what can be asked of them.
class Squares {
 public:
  Squares(std::span<const Point3> points, double radius) : size_(radius / kSquaresPerRadius) {
    for (const Point3& p : points) {
      const auto [it, fresh] = number_.try_emplace(Key(SquareAt(p.head<2>(), size_)), at_.size());
      if (fresh) at_.push_back(SquareAt(p.head<2>(), size_)), lowest_.push_back(p);
      if (p.z() < lowest_[it->second].z()) lowest_[it->second] = p;
    }
    for (int dx = -kSquaresPerRadius; dx <= kSquaresPerRadius; ++dx) {
      for (int dy = -kSquaresPerRadius; dy <= kSquaresPerRadius; ++dy) {
        if (dx * dx + dy * dy <= kSquaresPerRadius * kSquaresPerRadius) disc_.emplace_back(dx, dy);
      }
    }
  }

  // Of each square: the highest of the lowest that a disc around it, or within it, covers.
  std::vector<double> Opening() const {
    std::vector<double> eroded(at_.size(), std::numeric_limits<double>::infinity());
    std::vector<double> opened(at_.size(), -std::numeric_limits<double>::infinity());
    for (size_t i = 0; i < at_.size(); ++i) {
      ForDisc(at_[i], [&](size_t k) { eroded[i] = std::min(eroded[i], lowest_[k].z()); });
    }
    for (size_t i = 0; i < at_.size(); ++i) {
      ForDisc(at_[i], [&](size_t k) { opened[i] = std::max(opened[i], eroded[k]); });
    }
    return opened;
  }

  size_t NumberAt(const Point3& p) const { return number_.at(Key(SquareAt(p.head<2>(), size_))); }

  double SteepestDown(const Point3& from, const ObjectRule& rule) const {
    double steepest = 0;
    ForDisc(SquareAt(from.head<2>(), size_), [&](size_t k) {
      const double far = (lowest_[k] - from).head<2>().norm();
      const double drop = from.z() - lowest_[k].z() - rule.step_noise;
      if (far <= rule.radius && drop > steepest * far) steepest = drop / std::max(far, kNear);
    });
    return steepest;
  }

 private:
  static uint64_t Key(const Square& s) {
    return static_cast<uint64_t>(static_cast<uint32_t>(s.first)) << 32 | static_cast<uint32_t>(s.second);
  }

  template <typename Visit>
  void ForDisc(const Square& middle, const Visit& visit) const {
    for (const Square& d : disc_) {
      const auto it = number_.find(Key({middle.first + d.first, middle.second + d.second}));
      if (it != number_.end()) visit(it->second);
    }
  }

  double size_;
  std::vector<Square> disc_;
  std::unordered_map<uint64_t, size_t> number_;
  std::vector<Square> at_;
  std::vector<Point3> lowest_;
};

}  // namespace

std::vector<double> StepsDown(std::span<const Point3> rim, std::span<const Point3> surroundings,
                              const ObjectRule& rule) {
  std::vector<Point3> all(rim.begin(), rim.end());
  all.insert(all.end(), surroundings.begin(), surroundings.end());
  const Trend trend(all, kTrendSquare * rule.radius);
  for (Point3& p : all) p = trend.Without(p);
  const Squares squares(all, rule.radius);
  const std::vector<double> opened = squares.Opening();
  std::vector<double> steps(rim.size(), 0);
  for (size_t i = 0; i < rim.size(); ++i) {
    const bool above = all[i].z() - opened[squares.NumberAt(all[i])] > rule.least_height;
    if (above) steps[i] = squares.SteepestDown(all[i], rule);
  }
  return steps;
}

bool AreWalls(std::span<const double> steps, const ObjectRule& rule) {
  const auto steeper = [&](double least) {
    return std::count_if(steps.begin(), steps.end(), [least](double s) { return s > least; });
  };
  return 2 * steeper(rule.wall) >= std::max<ptrdiff_t>(1, steeper(rule.slope));
}

}  // namespace tilemend
