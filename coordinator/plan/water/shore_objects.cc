#include "coordinator/plan/water/shore_objects.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <tuple>
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

// The lowest height of every small square that has a point, row by row, and what can be asked of them.
class Squares {
 public:
  Squares(std::span<const Point3> points, double radius) : size_(radius / kSquaresPerRadius) {
    std::vector<std::pair<Square, Point3>> sorted;
    sorted.reserve(points.size());
    for (const Point3& p : points) sorted.emplace_back(SquareAt(p.head<2>(), size_), p);
    const auto key = [](const auto& s) { return std::tuple(s.first.second, s.first.first, s.second.z()); };
    std::stable_sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    for (const auto& [square, p] : sorted) {
      if (!at_.empty() && at_.back() == square) continue;
      if (rows_.empty() || rows_.back() != square.second) {
        rows_.push_back(square.second);
        row_begin_.push_back(at_.size());
      }
      at_.push_back(square);
      lowest_.push_back(p);
    }
    row_begin_.push_back(at_.size());
    for (int dy = 0; dy <= kSquaresPerRadius; ++dy) {
      half_width_.push_back(static_cast<int>(std::sqrt(kSquaresPerRadius * kSquaresPerRadius - dy * dy)));
    }
  }

  // Of each square: the highest of the lowest that a disc around it, or within it, covers.
  std::vector<double> Opening() const {
    std::vector<double> eroded(at_.size(), std::numeric_limits<double>::infinity());
    std::vector<double> opened(at_.size(), -std::numeric_limits<double>::infinity());
    ForDiscs([&](size_t i, size_t k) { eroded[i] = std::min(eroded[i], lowest_[k].z()); });
    ForDiscs([&](size_t i, size_t k) { opened[i] = std::max(opened[i], eroded[k]); });
    return opened;
  }

  size_t NumberAt(const Point3& p) const {
    const Square square = SquareAt(p.head<2>(), size_);
    return FirstFrom(FirstRow(square.second), square.first);
  }

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
  // The first row that is not above this one; into rows_.
  size_t FirstRow(int64_t row) const {
    return static_cast<size_t>(std::lower_bound(rows_.begin(), rows_.end(), row) - rows_.begin());
  }

  // The first square of a row (into rows_) at the column or after it.
  size_t FirstFrom(size_t row, int64_t column) const {
    const auto begin = at_.begin() + static_cast<ptrdiff_t>(row_begin_[row]);
    const auto end = at_.begin() + static_cast<ptrdiff_t>(row_begin_[row + 1]);
    const auto it = std::lower_bound(begin, end, column, [](const Square& s, int64_t c) { return s.first < c; });
    return static_cast<size_t>(it - at_.begin());
  }

  // Of each square i, in no order: every square k that a disc around it covers. Linear in such pairs.
  template <typename Visit>
  void ForDiscs(const Visit& visit) const {
    for (size_t row = 0; row < rows_.size(); ++row) {
      const size_t first = FirstRow(rows_[row] - kSquaresPerRadius);
      for (size_t r = first; r < rows_.size() && rows_[r] <= rows_[row] + kSquaresPerRadius; ++r) {
        const int half = half_width_[std::abs(rows_[r] - rows_[row])];
        size_t begin = row_begin_[r];
        for (size_t i = row_begin_[row]; i < row_begin_[row + 1]; ++i) {
          const int64_t x = at_[i].first;
          while (begin < row_begin_[r + 1] && at_[begin].first < x - half) ++begin;
          for (size_t k = begin; k < row_begin_[r + 1] && at_[k].first <= x + half; ++k) visit(i, k);
        }
      }
    }
  }

  template <typename Visit>
  void ForDisc(const Square& middle, const Visit& visit) const {
    const int64_t x = middle.first, y = middle.second;
    for (size_t r = FirstRow(y - kSquaresPerRadius); r < rows_.size() && rows_[r] <= y + kSquaresPerRadius; ++r) {
      const int half = half_width_[std::abs(rows_[r] - y)];
      for (size_t k = FirstFrom(r, x - half); k < row_begin_[r + 1] && at_[k].first <= x + half; ++k) visit(k);
    }
  }

  double size_;
  std::vector<Square> at_;  // column, row; by rows
  std::vector<Point3> lowest_;
  std::vector<int64_t> rows_;      // that have squares, ascending
  std::vector<size_t> row_begin_;  // into at_; one more than there are rows
  std::vector<int> half_width_;    // of the disc, in columns, by rows from its middle
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
  const auto rough = steeper(rule.rough), walls = steeper(rule.wall);
  if (3 * walls < std::max<ptrdiff_t>(1, rough)) return false;
  return 2 * rough <= std::ssize(steps) || 5 * walls >= 4 * steeper(rule.slope);
}

}  // namespace tilemend
