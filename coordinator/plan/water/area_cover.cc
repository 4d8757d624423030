#include "coordinator/plan/water/area_cover.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace tilemend {
namespace {

constexpr int kLines = 128;

struct Bounds {
  Point2 lo = Point2::Constant(std::numeric_limits<double>::infinity());
  Point2 hi = -lo;
};

Bounds BoundsOf(std::span<const PlaneSegment> segments) {
  Bounds box;
  for (const auto& [a, b] : segments) {
    box.lo = box.lo.cwiseMin(a).cwiseMin(b);
    box.hi = box.hi.cwiseMax(a).cwiseMax(b);
  }
  return box;
}

std::vector<PlaneSegment> SegmentsOf(const WaterArea& area) {
  std::vector<PlaneSegment> segments;
  for (const std::vector<Point2>& ring : area.polygon.rings) {
    for (size_t i = 0; i < ring.size(); ++i) segments.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  }
  return segments;
}

// Where the line at `y` crosses the segments, ascending: an even number of places for closed boundaries.
std::vector<double> Crossings(std::span<const PlaneSegment> segments, double y) {
  std::vector<double> at;
  for (const auto& [a, b] : segments) {
    if ((a.y() <= y) == (b.y() <= y)) continue;
    at.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(at.begin(), at.end());
  return at;
}

double Length(const std::vector<double>& intervals) {
  double sum = 0;
  for (size_t i = 0; i + 1 < intervals.size(); i += 2) sum += intervals[i + 1] - intervals[i];
  return sum;
}

// The length that lies in intervals of both.
double CommonLength(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (size_t i = 0, j = 0; i + 1 < a.size() && j + 1 < b.size();) {
    sum += std::max(0.0, std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]));
    (a[i + 1] < b[j + 1] ? i : j) += 2;
  }
  return sum;
}

}  // namespace

CoverLines::CoverLines(std::span<const PlaneSegment> boundary) {
  const Bounds box = BoundsOf(boundary);
  lo_ = box.lo, hi_ = box.hi;
  for (int k = 0; k < kLines; ++k) {
    const double y = lo_.y() + (k + 0.5) / kLines * (hi_.y() - lo_.y());
    lines_.push_back({y, Crossings(boundary, y)});
    length_ += Length(lines_.back().inside);
  }
}

double CoverLines::ShareIn(const WaterArea& area) const { return ShareIn(SegmentsOf(area)); }

double CoverLines::ShareIn(std::span<const PlaneSegment> outline) const {
  const Bounds covered = BoundsOf(outline);
  if ((hi_.array() < covered.lo.array()).any() || (covered.hi.array() < lo_.array()).any()) return 0;
  double common = 0;
  for (const Line& line : lines_) {
    const bool meets = line.y >= covered.lo.y() && line.y <= covered.hi.y();
    if (meets) common += CommonLength(line.inside, Crossings(outline, line.y));
  }
  return length_ > 0 ? common / length_ : 0;
}

}  // namespace tilemend
