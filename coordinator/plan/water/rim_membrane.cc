#include "coordinator/plan/water/rim_membrane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tilemend {
namespace {

constexpr double kSquares = 1000;    // inside, about: twice as many change the mean by less than a tenth of it
constexpr double kMaxSquares = 500;  // a side of the raster
constexpr double kRelaxation = 1.8;  // of successive over-relaxation: the best for 30 squares across
constexpr int kMaxSweeps = 300;
constexpr double kSettled = 0.001;  // metres

class Membrane {
 public:
  Membrane(std::span<const PlaneSegment> outline, std::span<const Point3> heights) : heights_(heights) {
    Eigen::AlignedBox2d box;
    double twice_area = 0;
    for (const auto& [a, b] : outline) box.extend(a).extend(b);
    for (const auto& [a, b] : outline) {
      const Point2 u = a - box.min(), v = b - box.min();
      twice_area += u.x() * v.y() - u.y() * v.x();
    }
    const double from_area = std::sqrt(std::abs(twice_area) / 2 / kSquares);
    const double step = std::max(from_area, box.sizes().maxCoeff() / kMaxSquares);
    columns_ = static_cast<size_t>(box.sizes().x() / step) + 3;  // one more on each side
    const size_t rows = static_cast<size_t>(box.sizes().y() / step) + 3;
    inside_.assign(columns_ * rows, false);
    height_.assign(inside_.size(), 0);
    lo_ = box.min() - Point2(step, step);
    step_ = step;
    for (size_t row = 0; row < rows; ++row) MarkInside(outline, row);
    Start();
  }

  // Successive over-relaxation, square after square in order.
  void Solve() {
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
      double largest = 0;
      for (const size_t s : squares_) {
        const double mean =
            (height_[s - 1] + height_[s + 1] + height_[s - columns_] + height_[s + columns_]) / 4 - height_[s];
        height_[s] += kRelaxation * mean;
        largest = std::max(largest, std::abs(mean));
      }
      if (largest < kSettled) break;
    }
  }

  double MeanOff(double level) const {
    double sum = 0;
    for (const size_t s : squares_) sum += std::abs(height_[s] - level);
    if (!squares_.empty()) return sum / static_cast<double>(squares_.size());
    for (const Point3& p : heights_) sum += std::abs(p.z() - level);  // narrower than a square
    return sum / static_cast<double>(heights_.size());
  }

 private:
  Point2 Middle(size_t square) const {
    const size_t whole_rows = square / columns_;
    const auto column = static_cast<double>(square % columns_), row = static_cast<double>(whole_rows);
    return lo_ + step_ * Point2(column + 0.5, row + 0.5);
  }

  void MarkInside(std::span<const PlaneSegment> outline, size_t row) {
    const double y = Middle(row * columns_).y();
    std::vector<double> at;
    for (const auto& [a, b] : outline) {
      if ((a.y() <= y) == (b.y() <= y)) continue;
      at.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    std::ranges::sort(at);
    for (size_t i = 0; i + 1 < at.size(); i += 2) {
      for (size_t s = row * columns_; s < (row + 1) * columns_; ++s) {
        const double x = Middle(s).x();
        if (x >= at[i] && x < at[i + 1]) inside_[s] = true;
      }
    }
  }

  double NearestHeight(size_t square) const {
    const Point2 middle = Middle(square);
    return std::ranges::min_element(heights_, {}, [&](const Point3& p) { return (p.head<2>() - middle).squaredNorm(); })
        ->z();
  }

  // Boundary values; the squares inside begin with the mean of all heights.
  void Start() {
    double mean = 0;
    for (const Point3& p : heights_) mean += p.z() / static_cast<double>(heights_.size());
    std::vector<bool> has_height(inside_.size(), false);
    for (size_t s = 0; s < inside_.size(); ++s) {
      if (!inside_[s]) continue;
      squares_.push_back(s);
      height_[s] = mean;
      for (const size_t other : {s - 1, s + 1, s - columns_, s + columns_}) {
        if (inside_[other] || has_height[other]) continue;
        has_height[other] = true;
        height_[other] = NearestHeight(other);
      }
    }
  }

  std::span<const Point3> heights_;
  Point2 lo_;
  double step_ = 0;
  size_t columns_ = 0;
  std::vector<bool> inside_;
  std::vector<double> height_;   // by square; of those inside and beside them
  std::vector<size_t> squares_;  // those inside
};

}  // namespace

double MeanOffLevel(std::span<const PlaneSegment> outline, std::span<const Point3> heights, double level) {
  Membrane membrane(outline, heights);
  membrane.Solve();
  return membrane.MeanOff(level);
}

}  // namespace tilemend
