#include "coordinator/plan/water/centreline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace tilemend {
namespace {

constexpr double kMostSquares = 1000;   // a side of the raster
constexpr double kSquaresPerWidth = 6;  // at least, where the side allows
constexpr size_t kSmallParts = 8;       // of the largest
constexpr double kFar = std::numeric_limits<double>::infinity();

Eigen::AlignedBox2d BoundsOfLines(std::span<const PlaneSegment> segments) {
  Eigen::AlignedBox2d box;
  for (const auto& [a, b] : segments) box.extend(a).extend(b);
  return box;
}

// The squares of a raster that lie in a region.
class Raster {
 public:
  Raster(std::span<const PlaneSegment> boundary, const Eigen::AlignedBox2d& box, double step)
      : lo_(box.min()), step_(step) {
    columns_ = static_cast<int32_t>(box.sizes().x() / step) + 1;
    rows_ = static_cast<int32_t>(box.sizes().y() / step) + 1;
    inside_.assign(static_cast<size_t>(columns_) * rows_, false);
    std::vector<std::vector<double>> crossings(rows_);
    for (const auto& [a, b] : boundary) AddCrossings(a, b, crossings);
    for (int32_t row = 0; row < rows_; ++row) {
      std::vector<double>& at = crossings[row];
      std::sort(at.begin(), at.end());
      for (size_t i = 0; i + 1 < at.size(); i += 2) FillBetween(row, at[i], at[i + 1]);
    }
  }

  size_t size() const { return inside_.size(); }
  double area() const { return AreaOf(static_cast<size_t>(std::count(inside_.begin(), inside_.end(), true))); }
  double AreaOf(size_t squares) const { return step_ * step_ * static_cast<double>(squares); }
  bool inside(size_t square) const { return inside_[square]; }
  Point2 Middle(size_t square) const {
    const size_t column = square % columns_, row = square / columns_;
    return lo_ + step_ * Point2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
  }

  // The way to each square within the region from the first one, in metres; kFar where none leads.
  std::vector<double> WaysFrom(size_t first) const {
    std::vector<double> way(size(), kFar);
    using Entry = std::pair<double, size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
    way[first] = 0;
    next.emplace(0, first);
    while (!next.empty()) {
      const double far = next.top().first;
      const size_t square = next.top().second;
      next.pop();
      if (far > way[square]) continue;
      ForNeighbours(square, [&](size_t other, double step) {
        if (far + step >= way[other]) return;
        way[other] = far + step;
        next.emplace(way[other], other);
      });
    }
    return way;
  }

  // Marks the squares that hang together with the first one; returns how many.
  size_t MarkPart(size_t first, std::vector<bool>& seen) const {
    std::vector<size_t> next = {first};
    seen[first] = true;
    size_t count = 0;
    while (!next.empty()) {
      const size_t square = next.back();
      next.pop_back();
      ++count;
      ForNeighbours(square, [&](size_t other, double) {
        if (seen[other]) return;
        seen[other] = true;
        next.push_back(other);
      });
    }
    return count;
  }

 private:
  void AddCrossings(const Point2& a, const Point2& b, std::vector<std::vector<double>>& crossings) const {
    const double lo = (std::min(a.y(), b.y()) - lo_.y()) / step_ - 0.5,
                 hi = (std::max(a.y(), b.y()) - lo_.y()) / step_ - 0.5;
    for (auto row = static_cast<int32_t>(std::max(0.0, std::floor(lo))); row <= hi && row < rows_; ++row) {
      const double y = lo_.y() + (row + 0.5) * step_;
      if ((a.y() <= y) == (b.y() <= y)) continue;
      crossings[row].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }

  void FillBetween(int32_t row, double from, double to) {
    const auto first = static_cast<int32_t>(std::ceil((from - lo_.x()) / step_ - 0.5));
    const auto last = static_cast<int32_t>(std::floor((to - lo_.x()) / step_ - 0.5));
    for (int32_t c = std::max(first, 0); c <= std::min(last, columns_ - 1); ++c) {
      inside_[static_cast<size_t>(row) * columns_ + c] = true;
    }
  }

  template <typename Visit>
  void ForNeighbours(size_t square, const Visit& visit) const {
    const auto column = static_cast<int32_t>(square % columns_), row = static_cast<int32_t>(square / columns_);
    for (int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, rows_ - 1); ++r) {
      for (int32_t c = std::max(column - 1, 0); c <= std::min(column + 1, columns_ - 1); ++c) {
        const size_t other = static_cast<size_t>(r) * columns_ + c;
        if (other != square && inside_[other]) visit(other, step_ * std::hypot(r - row, c - column));
      }
    }
  }

  Point2 lo_;
  double step_;
  int32_t columns_, rows_;
  std::vector<bool> inside_;
};

size_t FarthestOf(const std::vector<double>& ways) {
  size_t best = 0;
  for (size_t i = 0; i < ways.size(); ++i) {
    if (ways[i] < kFar && (ways[best] == kFar || ways[i] > ways[best])) best = i;
  }
  return best;
}

// Squares that hang together: how many, and the first one.
struct RasterPart {
  size_t count, first;
};

// The largest first, without those that are much smaller.
std::vector<RasterPart> LargePartsOf(const Raster& raster) {
  std::vector<bool> seen(raster.size(), false);
  std::vector<RasterPart> parts;
  for (size_t i = 0; i < raster.size(); ++i) {
    if (raster.inside(i) && !seen[i]) parts.push_back({raster.MarkPart(i, seen), i});
  }
  std::ranges::stable_sort(parts, std::greater<>(), &RasterPart::count);
  std::erase_if(parts, [&](const RasterPart& part) { return part.count * kSmallParts < parts.front().count; });
  return parts;
}

double LengthOf(const std::vector<Point2>& line) {
  double length = 0;
  for (size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

// The middles of bins of what is as far along, with the line drawn on by half a bin at its ends.
std::vector<Point2> MiddlesAlong(const Raster& raster, const std::vector<double>& from_a,
                                 const std::vector<double>& from_b, double length, double station) {
  const auto bins = static_cast<size_t>(std::max(2.0, std::ceil(length / station)));
  std::vector<Point2> sum(bins, Point2(0, 0));
  std::vector<double> count(bins, 0);
  for (size_t i = 0; i < raster.size(); ++i) {
    if (from_a[i] == kFar) continue;
    const double along = (from_a[i] - from_b[i] + length) / 2 / length;
    const size_t bin = std::min(bins - 1, static_cast<size_t>(std::max(0.0, along) * static_cast<double>(bins)));
    sum[bin] += raster.Middle(i);
    ++count[bin];
  }
  std::vector<Point2> line;
  for (size_t k = 0; k < bins; ++k) {
    if (count[k] > 0) line.emplace_back(sum[k] / count[k]);
  }
  if (line.size() < 2) return {};
  const Point2 first = line[0] + (line[0] - line[1]) / 2,
               last = line.back() + (line.back() - line[line.size() - 2]) / 2;
  line.insert(line.begin(), first);
  line.push_back(last);
  return line;
}

Centreline LineAlong(const Raster& raster, const RasterPart& part, double station) {
  Centreline line;
  const size_t a = FarthestOf(raster.WaysFrom(part.first));
  const std::vector<double> from_a = raster.WaysFrom(a);
  const size_t b = FarthestOf(from_a);
  if (!(from_a[b] > 0)) return line;
  line.points = MiddlesAlong(raster, from_a, raster.WaysFrom(b), from_a[b], station);
  line.length = LengthOf(line.points);
  if (line.length > 0) line.width = raster.AreaOf(part.count) / line.length;
  return line;
}

}  // namespace

std::vector<Centreline> FindCentrelines(std::span<const PlaneSegment> boundary, double station) {
  const Eigen::AlignedBox2d box = BoundsOfLines(boundary);
  if (boundary.empty() || !(box.sizes().minCoeff() > 0)) return {};
  const double coarse = box.sizes().maxCoeff() / kMostSquares;
  // A first look tells the width: a long region's area over half of its outline.
  const double area = Raster(boundary, box, 4 * coarse).area();
  const double step = std::max(coarse, area / box.diagonal().norm() / kSquaresPerWidth / 2);
  const Raster raster(boundary, box, step);
  std::vector<Centreline> lines;
  for (const RasterPart& part : LargePartsOf(raster)) lines.push_back(LineAlong(raster, part, station));
  std::erase_if(lines, [](const Centreline& line) { return line.points.size() < 2; });
  return lines;
}

}  // namespace tilemend
