#include "coordinator/plan/water/given_line.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "coordinator/plan/water/rim_level.h"
#include "coordinator/plan/water/river_profile.h"
#include "coordinator/plan/water/shore.h"

namespace tilemend {
namespace {

constexpr double kBack = -0.866;      // cosine of a turn of 150 degrees
constexpr double kAnyStep = 0x1p-20;  // metres

using Line = std::vector<Point2>;

double Side(const Point2& a, const Point2& b, const Point2& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool Cross(const Point2& a, const Point2& b, const PlaneSegment& s) {
  return (Side(a, b, s.first) > 0) != (Side(a, b, s.second) > 0) &&
         (Side(s.first, s.second, a) > 0) != (Side(s.first, s.second, b) > 0);
}

bool IsInside(const std::vector<PlaneSegment>& boundary, const Point2& p) {
  bool inside = false;
  for (const auto& [a, b] : boundary) {
    if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
    if (a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x()) inside = !inside;
  }
  return inside;
}

bool RunsThrough(const Line& line, const std::vector<PlaneSegment>& boundary) {
  Eigen::AlignedBox2d box;
  for (const auto& [a, b] : boundary) box.extend(a).extend(b);
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    if (!box.intersects(Eigen::AlignedBox2d(line[i]).extend(line[i + 1]))) continue;
    if (std::ranges::any_of(boundary, [&](const PlaneSegment& s) { return Cross(line[i], line[i + 1], s); })) {
      return true;
    }
  }
  return IsInside(boundary, line.front());
}

// Whether the shore of a reach is off the level along the river.
bool IsOff(const Reach& reach, const WaterSurface& river, double tolerance) {
  if (reach.shore.size() < kLeastShore) return false;
  std::vector<double> above;
  for (const Point3& p : reach.shore) above.push_back(p.z() - LevelAt(river, p.head<2>(), kAnyStep));
  const RimLevel fit = FitLowLevel(std::move(above), reach.noise);
  return std::abs(fit.level) > tolerance + std::min(tolerance, fit.spread);
}

WaterSurface SurfaceAlong(const Line& line, const std::vector<const Reach*>& reaches, double tolerance) {
  std::vector<Point3> shore;
  std::vector<double> noises;
  for (const Reach* reach : reaches) {
    shore.insert(shore.end(), reach->shore.begin(), reach->shore.end());
    noises.push_back(reach->noise);
  }
  return FitRiver(line, shore, Quantile(noises, 0.5), {.tolerance = tolerance}).water;
}

bool IsBefore(const Line& a, const Line& b) {
  return std::ranges::lexicographical_compare(
      a, b, [](const Point2& p, const Point2& q) { return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y()); });
}

}  // namespace

void LeaveOtherWater(double tolerance, std::vector<Reach>& reaches) {
  std::map<Line, std::vector<Reach*>, decltype(&IsBefore)> along(&IsBefore);
  for (Reach& reach : reaches) {
    if (reach.centreline.size() > 1) along[reach.centreline].push_back(&reach);
  }
  for (const auto& [line, all] : along) {
    std::vector<const Reach*> on;
    std::vector<Reach*> beside;
    for (Reach* reach : all) {
      if (RunsThrough(line, reach->boundary)) {
        on.push_back(reach);
      } else {
        beside.push_back(reach);
      }
    }
    if (on.empty() || beside.empty()) continue;
    const WaterSurface river = SurfaceAlong(line, on, tolerance);
    if (river.stations.empty()) continue;
    for (Reach* reach : beside) {
      if (IsOff(*reach, river, tolerance)) reach->centreline.clear();
    }
  }
}

std::optional<Point2> WhereItTurnsBack(std::span<const Point2> line) {
  Point2 before(0, 0);
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const Point2 step = line[i + 1] - line[i];
    if (step.isZero(0)) continue;
    if (before.dot(step) < kBack * before.norm() * step.norm()) return line[i];
    before = step;
  }
  return std::nullopt;
}

}  // namespace tilemend
