#include "coordinator/plan/water/area_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

constexpr int kLines = 128;
constexpr double kSameLevel = 0.01;  // metres between levels that were given

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

// Intervals that overlap are one.
std::vector<double> UnionOf(std::vector<std::pair<double, double>> parts) {
  std::sort(parts.begin(), parts.end());
  std::vector<double> ends;
  for (const auto& [low, high] : parts) {
    if (!ends.empty() && low <= ends.back()) {
      ends.back() = std::max(ends.back(), high);
    } else {
      ends.insert(ends.end(), {low, high});
    }
  }
  return ends;
}

}  // namespace

bool SayTheSame(const WaterArea& a, const WaterArea& b) {
  if (a.water != b.water || a.decision != b.decision || a.kind != b.kind || a.clear != b.clear ||
      a.level.has_value() != b.level.has_value())
    return false;
  if (!a.centreline.empty() || !b.centreline.empty()) return false;
  if (!a.level) return true;
  return std::abs(*a.level - *b.level) <= std::max({kSameLevel, a.level_sigma.value_or(0), b.level_sigma.value_or(0)});
}

CoverLines::CoverLines(std::span<const PlaneSegment> boundary) {
  const Bounds box = BoundsOf(boundary);
  lo_ = box.lo, hi_ = box.hi;
  for (int k = 0; k < kLines; ++k) {
    const double y = lo_.y() + (k + 0.5) / kLines * (hi_.y() - lo_.y());
    lines_.push_back({y, Crossings(boundary, y)});
    length_ += Length(lines_.back().inside);
  }
}

double CoverLines::ShareIn(const WaterArea& area) const {
  Bounds box;  // without the segments: most areas are elsewhere
  for (const std::vector<Point2>& ring : area.polygon.rings) {
    for (const Point2& p : ring) {
      box.lo = box.lo.cwiseMin(p);
      box.hi = box.hi.cwiseMax(p);
    }
  }
  return Meets(box.lo, box.hi) ? ShareIn(SegmentsOf(area)) : 0;
}

bool CoverLines::Meets(const Point2& lo, const Point2& hi) const {
  return (hi_.array() >= lo.array()).all() && (hi.array() >= lo_.array()).all();
}

double CoverLines::ShareIn(std::span<const PlaneSegment> outline) const {
  const Bounds covered = BoundsOf(outline);
  if (!Meets(covered.lo, covered.hi)) return 0;
  double common = 0;
  for (const Line& line : lines_) {
    const bool meets = line.y >= covered.lo.y() && line.y <= covered.hi.y();
    if (meets) common += CommonLength(line.inside, Crossings(outline, line.y));
  }
  return length_ > 0 ? common / length_ : 0;
}

double CoverLines::ShareIn(std::span<const WaterArea* const> areas) const {
  double common = 0;
  for (const Line& line : lines_) {
    std::vector<std::pair<double, double>> parts;
    for (const WaterArea* area : areas) {
      const std::vector<double> at = Crossings(SegmentsOf(*area), line.y);
      for (size_t i = 0; i + 1 < at.size(); i += 2) parts.emplace_back(at[i], at[i + 1]);
    }
    common += CommonLength(line.inside, UnionOf(std::move(parts)));
  }
  return length_ > 0 ? common / length_ : 0;
}

std::optional<DecidingArea> FindDecidingArea(const CoverLines& region, std::span<const double> shares,
                                             std::span<const WaterArea> areas) {
  for (size_t a = shares.size(); a-- > 0;) {
    if (shares[a] > kDecidingShare) return DecidingArea{a, shares[a], false};
  }
  std::optional<DecidingArea> most;
  for (size_t a = 0; a < shares.size(); ++a) {
    if (shares[a] <= 0 || (most && shares[a] <= shares[most->area])) continue;
    std::vector<const WaterArea*> same;
    double sum = 0;
    for (size_t b = 0; b < shares.size(); ++b) {
      if (shares[b] <= 0 || !SayTheSame(areas[a], areas[b])) continue;
      same.push_back(&areas[b]);
      sum += shares[b];
    }
    if (sum <= kDecidingShare) continue;
    const double share = region.ShareIn(same);
    if (share > kDecidingShare) most = DecidingArea{a, share, true};
  }
  return most;
}

}  // namespace tilemend
