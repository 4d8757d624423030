// Regions like those of real holes, and the quality of their triangles.
#ifndef TILEMEND_TESTS_WORKER_FILL_REGION_REFINE_QUALITY_H_
#define TILEMEND_TESTS_WORKER_FILL_REGION_REFINE_QUALITY_H_

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "tests/common/mesh/triangulation/region_checks.h"
#include "worker/fill/region/refine_region.h"

namespace tilemend::testing {

// A region with the wanted size at each point.
struct SizedRegion : Region {
  std::vector<double> size;
};

// The mean length of the segments at each point.
inline void SetSizesFromSegments(SizedRegion& region) {
  std::vector<double> sum(region.points.size(), 0), count(region.points.size(), 0);
  for (const RegionSegment& s : region.segments) {
    const LatticePoint a = region.points[s.from], b = region.points[s.to];
    const double length = std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
    for (int32_t v : {s.from, s.to}) {
      sum[v] += length;
      count[v] += 1;
    }
  }
  region.size.resize(region.points.size());
  for (size_t v = 0; v < sum.size(); ++v) region.size[v] = count[v] > 0 ? sum[v] / count[v] : 1;
}

// A closed curve sampled at about `spacing`, each sample moved along and across by up to `jitter` * spacing.
inline std::vector<LatticePoint> SampleCurve(const std::function<std::array<double, 2>(double)>& curve, double spacing,
                                             double jitter, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shake(-jitter * spacing, jitter * spacing);
  const int fine = 200'000;
  double length = 0, walked = 0;
  std::array<double, 2> before = curve(0);
  for (int i = 1; i <= fine; ++i) {
    const auto p = curve(static_cast<double>(i) / fine);
    length += std::hypot(p[0] - before[0], p[1] - before[1]);
    before = p;
  }
  const int count = std::max(3, static_cast<int>(std::lround(length / spacing)));
  std::vector<LatticePoint> loop;
  before = curve(0);
  for (int i = 0; i < fine; ++i) {
    const auto p = curve(static_cast<double>(i) / fine);
    walked += std::hypot(p[0] - before[0], p[1] - before[1]);
    before = p;
    if (walked < length / count * static_cast<double>(loop.size())) continue;
    if (static_cast<int>(loop.size()) == count) break;
    const double x = p[0] + shake(random);
    loop.push_back({std::llround(x), std::llround(p[1] + shake(random))});
  }
  return loop;
}

// A winding river: `length` along x, banks `width` apart. All in units of the rim spacing `spacing` (lattice steps).
inline SizedRegion River(double length, double width, double spacing, double jitter, uint32_t seed) {
  const auto curve = [=](double u) -> std::array<double, 2> {
    const double end = width / (2 * (length + width));  // the share of either end
    const auto middle = [&](double x) { return 1.5 * width * std::sin(4 * x / (1.5 * width) / 2); };
    double x = 0, off = 0;
    if (u < 0.5 - end) {
      x = length * u / (0.5 - end);
      off = -width / 2;
    } else if (u < 0.5) {
      x = length;
      off = -width / 2 + width * (u - 0.5 + end) / end;
    } else if (u < 1 - end) {
      x = length * (1 - (u - 0.5) / (0.5 - end));
      off = width / 2;
    } else {
      off = width / 2 - width * (u - 1 + end) / end;
    }
    const double bank =
        0.06 * width * std::sin(x / width * 9) * (off > 0 ? 1 : -0.7) * std::sin(std::numbers::pi * x / length);
    return {x * spacing, (middle(x) + off + bank) * spacing};
  };
  SizedRegion region;
  region.Loop(SampleCurve(curve, spacing, jitter, seed));
  SetSizesFromSegments(region);
  return region;
}

inline SizedRegion Disc(double radius, double spacing, double jitter, uint32_t seed) {
  SizedRegion region;
  region.Loop(SampleCurve(
      [=](double u) -> std::array<double, 2> {
        const double angle = 2 * std::numbers::pi * u;
        return {radius * spacing * std::cos(angle), radius * spacing * std::sin(angle)};
      },
      spacing, jitter, seed));
  SetSizesFromSegments(region);
  return region;
}

// A square of side * spacing with evenly spaced rim points: collinear, as along grid borders.
inline SizedRegion GridSquare(int side, int64_t spacing) {
  std::vector<LatticePoint> loop;
  for (int i = 0; i < side; ++i) loop.push_back({i * spacing, 0});
  for (int i = 0; i < side; ++i) loop.push_back({side * spacing, i * spacing});
  for (int i = 0; i < side; ++i) loop.push_back({(side - i) * spacing, side * spacing});
  for (int i = 0; i < side; ++i) loop.push_back({0, (side - i) * spacing});
  SizedRegion region;
  region.Loop(loop);
  SetSizesFromSegments(region);
  return region;
}

struct Quality {
  double mean = 0;
  double least = 1;
  double fifth_percentile = 0;
  double least_inside = 1;  // among triangles without a segment and with at least two new corners
  size_t triangles = 0;
};

inline std::vector<LatticePoint> AllPoints(const Region& region, const RefinedRegion& refined) {
  std::vector<LatticePoint> points = region.points;
  points.insert(points.end(), refined.new_points.begin(), refined.new_points.end());
  return points;
}

inline double Distance(LatticePoint a, LatticePoint b) {
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
}

// 2 * inradius / circumradius.
inline double TriangleQuality(LatticePoint a, LatticePoint b, LatticePoint c) {
  const double x = Distance(a, b), y = Distance(b, c), z = Distance(c, a);
  const double area2 = static_cast<double>(Cross(a, b, c));
  return 4 * area2 * area2 / ((x + y + z) * x * y * z);
}

inline Quality Measure(const Region& region, const RefinedRegion& refined) {
  const std::vector<LatticePoint> points = AllPoints(region, refined);
  Quality quality;
  std::vector<double> all;
  for (const Triangle& t : refined.triangulation.triangles) {
    const double q = TriangleQuality(points[t[0]], points[t[1]], points[t[2]]);
    all.push_back(q);
    quality.mean += q;
    quality.least = std::min(quality.least, q);
    const auto is_new = [&](int32_t v) { return v >= static_cast<int32_t>(region.points.size()); };
    if (is_new(t[0]) + is_new(t[1]) + is_new(t[2]) >= 2) quality.least_inside = std::min(quality.least_inside, q);
  }
  quality.triangles = all.size();
  if (all.empty()) return quality;
  quality.mean /= static_cast<double>(all.size());
  std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 20), all.end());
  quality.fifth_percentile = all[all.size() / 20];
  return quality;
}

}  // namespace tilemend::testing

#endif  // TILEMEND_TESTS_WORKER_FILL_REGION_REFINE_QUALITY_H_
