#include "coordinator/plan/water/given_line.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace tilemend {
namespace {

constexpr double kBack = -0.866;  // cosine of a turn of 150 degrees

double Side(const Point2& a, const Point2& b, const Point2& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool Cross(const Point2& a, const Point2& b, const PlaneSegment& s) {
  return (Side(a, b, s.first) > 0) != (Side(a, b, s.second) > 0) &&
         (Side(s.first, s.second, a) > 0) != (Side(s.first, s.second, b) > 0);
}

bool IsInside(std::span<const PlaneSegment> outline, const Point2& p) {
  bool inside = false;
  for (const auto& [a, b] : outline) {
    if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
    if (a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x()) inside = !inside;
  }
  return inside;
}

}  // namespace

bool RunsThrough(std::span<const Point2> line, std::span<const PlaneSegment> outline) {
  Eigen::AlignedBox2d box;
  for (const auto& [a, b] : outline) box.extend(a).extend(b);
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    if (!box.intersects(Eigen::AlignedBox2d(line[i]).extend(line[i + 1]))) continue;
    if (std::ranges::any_of(outline, [&](const PlaneSegment& s) { return Cross(line[i], line[i + 1], s); })) {
      return true;
    }
  }
  return IsInside(outline, line.front());
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
