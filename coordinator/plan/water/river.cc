#include "coordinator/plan/water/river.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "coordinator/plan/water/centreline.h"
#include "coordinator/plan/water/river_profile.h"

namespace tilemend {
namespace {

constexpr double kStation = 25;    // metres
constexpr double kBentEnd = 0.75;  // widths from its end: there a centreline bends into a corner
// How much smaller than the level's J that of the line is, and stations with a level: a line goes through any two, and
// by default it invents falls of level water.
constexpr double kFarBetter = 0.2, kBetter = 1.0 / 3;
constexpr size_t kMinStations = 4, kManyStations = 8;
constexpr double kLongestPerWidth = 1;  // a reach is longer than wide

// Takes off the bend at the last end of a line.
void TakeOffBend(double bend, std::vector<Point2>& points) {
  double off = 0;
  while (points.size() > 2 && off < bend) {
    const Point2 last = points.back();
    points.pop_back();
    off += (last - points.back()).norm();
  }
}

std::vector<Centreline> LinesOf(std::span<const std::vector<PlaneSegment>> reaches, double min_width) {
  std::vector<Centreline> lines;
  for (const std::vector<PlaneSegment>& reach : reaches) {
    for (Centreline& line : FindCentrelines(reach, kStation)) {
      if (line.points.size() < 2 || line.width < min_width) continue;
      if (line.length > kLongestPerWidth * line.width) lines.push_back(std::move(line));
    }
  }
  return lines;
}

// Puts `line` at the end of `axis`, or at its beginning, where they are nearest.
void Link(Centreline line, std::vector<Point2>& axis) {
  const double bend = kBentEnd * line.width;
  std::vector<Point2>& points = line.points;
  const auto gap_to = [&](const Point2& end) {
    return std::min((points.front() - end).norm(), (points.back() - end).norm());
  };
  const bool at_front = gap_to(axis.front()) < gap_to(axis.back());
  if (at_front) std::ranges::reverse(axis);
  if ((points.back() - axis.back()).norm() > (points.front() - axis.back()).norm()) std::ranges::reverse(points);
  TakeOffBend(bend, points);
  TakeOffBend(bend, axis);
  axis.insert(axis.end(), points.rbegin(), points.rend());
  if (at_front) std::ranges::reverse(axis);
}

}  // namespace

std::vector<Point2> RiverAxis(std::span<const std::vector<PlaneSegment>> reaches, double min_width) {
  std::vector<Centreline> lines = LinesOf(reaches, min_width);
  if (lines.empty()) return {};
  const auto longest = std::ranges::max_element(lines, {}, &Centreline::length);
  std::vector<Point2> axis = longest->points;
  lines.erase(longest);
  while (!lines.empty()) {
    const auto gap = [&](const Centreline& line) {
      double least = std::numeric_limits<double>::infinity();
      for (const Point2& a : {line.points.front(), line.points.back()}) {
        for (const Point2& b : {axis.front(), axis.back()}) least = std::min(least, (a - b).norm());
      }
      return least;
    };
    const auto next = std::ranges::min_element(lines, {}, gap);
    Link(std::move(*next), axis);
    lines.erase(next);
  }
  return axis;
}

bool MayFall(const LevelEvidence& level) { return level.disagreement > level.noise; }

std::optional<FallingWater> FindFall(const std::vector<Point2>& axis, std::span<const RimChain> rim,
                                     std::span<const PlaneSegment> outline, const LevelEvidence& level,
                                     bool is_known_river) {
  if (!MayFall(level)) return std::nullopt;
  FallLine fall = FitFall(axis, rim);
  if (fall.with_level < kMinStations || fall.slope == 0) return std::nullopt;
  const double better = is_known_river ? 1 : fall.with_level < kManyStations ? kFarBetter : kBetter;
  if (fall.slope > 0) {
    std::ranges::reverse(fall.stations);
    fall.slope = -fall.slope;
  }
  FallingWater river;
  const auto end = static_cast<double>(fall.stations.size() - 1);
  for (size_t k = 0; k < fall.stations.size(); ++k) {
    const double above_end = fall.slope * (static_cast<double>(k) - end);
    river.water.stations.emplace_back(fall.stations[k].x(), fall.stations[k].y(), above_end);
  }
  std::vector<RimChain> moved(rim.begin(), rim.end());
  for (RimChain& chain : moved) {
    for (ChainEdge& e : chain) e.middle.z() -= LevelAt(river.water, e.middle.head<2>(), 0x1p-20);
  }
  river.evidence = EvidenceOf(moved, outline);
  if (!river.evidence.is_level() || river.evidence.disagreement >= better * level.disagreement) return std::nullopt;
  for (Point3& s : river.water.stations) s.z() += river.evidence.level;
  return river;
}

std::vector<RimChain> AboveRiver(const WaterSurface& river, std::vector<RimChain> rim) {
  for (RimChain& chain : rim) {
    for (ChainEdge& e : chain) e.middle.z() -= LevelAt(river, e.middle.head<2>(), 0x1p-20);
  }
  return rim;
}

bool CanBeOneLevel(double apart, const LevelEvidence& a, const LevelEvidence& b) {
  return std::abs(apart) <= kSigmas * std::max(kMinSigma, std::hypot(a.sigma(), b.sigma()));
}

}  // namespace tilemend
