#include "coordinator/plan/seam/seam_vertices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/mesh/rounding.h"

namespace tilemend {
namespace {

// Of the wanted edge length: places nearer than this to the rim are none.
constexpr double kRimClearance = 0.4;
// In uniform mode sizes go from those of the rim near by to its mean, slowly: a lone outlier is not followed.
constexpr double kUniformGrowth = 0.02;
// Where tiles overlap, how long edges are at most: of the distance to the rim, or of the mean size at the rim. In the
// strip of two tiles both have one surface up to the last vertex before the rim.
constexpr double kOfDistance = 0.5;
constexpr double kLeastOfMean = 0.1;

// A stretch of a line.
struct Stretch {
  int axis;  // along the line
  double line, begin, end;

  Point2 At(double t) const {
    Point2 p;
    p[axis] = t;
    p[1 - axis] = line;
    return p;
  }
};

// The integral of 1 / size along a stretch, as (place, value) by small steps: how many edges fit up to there. None if
// they are more than `most`, or once the plan is cancelled.
std::optional<std::vector<std::pair<double, double>>> CountEdges(const SeamSite& site, const Stretch& stretch,
                                                                 int64_t most) {
  std::vector<std::pair<double, double>> steps = {{stretch.begin, 0.0}};
  double sum = 0;
  for (double t = stretch.begin; t < stretch.end;) {
    const double size = SeamSizeAt(site, stretch.At(t));
    const double next = std::min(stretch.end, t + size / 8);
    if (next <= t || sum > static_cast<double>(most) || site.options.cancelled()) return std::nullopt;
    sum += (next - t) / size;
    t = next;
    steps.emplace_back(t, sum);
  }
  return steps;
}

std::optional<std::vector<SeamPlace>> SpacedPlaces(const SeamSite& site, const Stretch& stretch, int64_t most) {
  const auto counted = CountEdges(site, stretch, most);
  if (!counted) return std::nullopt;
  const std::vector<std::pair<double, double>>& steps = *counted;
  const double sum = steps.back().second;
  const auto edges = std::max<int64_t>(1, std::llround(sum));
  std::vector<SeamPlace> places;
  size_t k = 0;
  for (int64_t i = 1; i < edges; ++i) {
    const double share = sum * static_cast<double>(i) / static_cast<double>(edges);
    while (k + 1 < steps.size() && steps[k + 1].second < share) ++k;
    const double f = (share - steps[k].second) / (steps[k + 1].second - steps[k].second);
    const double t = steps[k].first + f * (steps[k + 1].first - steps[k].first);
    if (site.options.cancelled()) return std::nullopt;
    const Point2 p = stretch.At(RoundedToLattice(t, site.lattice_step));
    if (p[stretch.axis] <= stretch.begin || p[stretch.axis] >= stretch.end) continue;
    const double size = SeamSizeAt(site, p);
    if (site.index.Distance(p, size) < kRimClearance * size) continue;
    if (places.empty() || p != places.back().position) places.push_back({p});
  }
  return places;
}

// Opposite the rim points that lie a hair off the line.
std::vector<SeamPlace> PlacesBesideRim(const SeamSite& site, const Stretch& stretch) {
  const int along = stretch.axis, across = 1 - along;
  Point2 lo = stretch.At(stretch.begin), hi = stretch.At(stretch.end);
  lo[across] -= kOnLine, hi[across] += kOnLine;
  std::map<double, int32_t> near;  // by place along the line
  for (const int32_t e : site.index.EdgesIn(lo, hi)) {
    const int32_t v = site.rim.edges[e].from;
    const Point3& p = site.rim.points[v].position;
    const bool has_height = site.rim.points[v].index >= 0;
    if (has_height && std::abs(p[across] - stretch.line) <= kOnLine) near.emplace(p[along], v);
  }
  std::vector<SeamPlace> places;
  double last = stretch.begin;
  for (const auto& [t, v] : near) {
    if (t <= last + kOnLine || t >= stretch.end - kOnLine) continue;
    last = t;
    if (std::abs(site.rim.points[v].position[across] - stretch.line) <= kSamePlace) continue;
    places.push_back({stretch.At(t), v});
  }
  return places;
}

}  // namespace

std::vector<Point2> SpacedBetween(const SeamSite& site, const Point2& from, const Point2& to) {
  const double length = (to - from).norm();
  std::vector<double> steps = {0}, counts = {0};
  while (steps.back() < length && !site.options.cancelled()) {
    const double size = SeamSizeAt(site, from + steps.back() / length * (to - from));
    const double least = length / static_cast<double>(kMostSeamEdges);
    const double next = std::min(length, steps.back() + std::max(size / 8, least));
    counts.push_back(counts.back() + (next - steps.back()) / size);
    steps.push_back(next);
  }
  const int64_t edges = std::llround(std::min(counts.back(), static_cast<double>(kMostSeamEdges)));
  std::vector<Point2> places;
  size_t k = 1;
  for (int64_t i = 1; i < edges; ++i) {
    const double share = counts.back() * static_cast<double>(i) / static_cast<double>(edges);
    while (counts[k] < share) ++k;
    const double f = (share - counts[k - 1]) / (counts[k] - counts[k - 1]);
    places.emplace_back(from + (steps[k - 1] + f * (steps[k] - steps[k - 1])) / length * (to - from));
  }
  return places;
}

double SeamSizeAt(const SeamSite& site, const Point2& p) {
  const double mean = site.index.mean_size();
  const double size = site.options.uniform
                          ? site.index.SizeAt(p, kUniformGrowth, mean)
                          : site.index.SizeAt(p, site.options.gradation - 1, site.options.size_limit * mean);
  if (!site.lines.joined) return size;
  return std::min(size, std::max(kLeastOfMean * mean, kOfDistance * site.index.Distance(p, size / kOfDistance)));
}

std::optional<std::vector<SeamPlace>> PlaceSeamVertices(const SeamSite& site, const Border& border, const Point2& from,
                                                        const Point2& to, int64_t most) {
  const int axis = AxisAlong(border);
  const Stretch stretch{axis, LineOf(border, site.area, site.lines), from[axis], to[axis]};
  std::optional<std::vector<SeamPlace>> spaced = SpacedPlaces(site, stretch, most);
  if (!spaced) return std::nullopt;
  std::vector<SeamPlace>& places = *spaced;
  const bool inner = site.area.contains(border.first) && site.area.contains(border.second);
  if (inner) return spaced;
  const std::vector<SeamPlace> beside = PlacesBesideRim(site, stretch);
  places.insert(places.end(), beside.begin(), beside.end());
  std::sort(places.begin(), places.end(),
            [&](const SeamPlace& a, const SeamPlace& b) { return a.position[axis] < b.position[axis]; });
  return spaced;
}

}  // namespace tilemend
