#include "common/mesh/outline_crossing.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace tilemend {
namespace {

constexpr double kTolerance = 1e-9;  // of the largest coordinate

struct Segment {
  Point2 a, b;
  OutlineCrossing::Edge edge;
  double lo_x() const { return std::min(a.x(), b.x()); }
  double hi_x() const { return std::max(a.x(), b.x()); }
  bool SharesY(const Segment& other) const {
    return std::min(a.y(), b.y()) <= std::max(other.a.y(), other.b.y()) &&
           std::min(other.a.y(), other.b.y()) <= std::max(a.y(), b.y());
  }
  // The distance of `p` from its line, positive to the left.
  double Beside(const Point2& p) const {
    const Point2 along = b - a, to = p - a;
    return (along.x() * to.y() - along.y() * to.x()) / along.norm();
  }
};

std::vector<Segment> SegmentsOf(const PlanePolygon& polygon) {
  std::vector<Segment> segments;
  for (size_t ring = 0; ring < polygon.rings.size(); ++ring) {
    const std::vector<Point2>& points = polygon.rings[ring];
    for (size_t i = 0; i < points.size(); ++i) {
      const Segment segment{points[i], points[(i + 1) % points.size()], {ring, i}};
      if (segment.a != segment.b) segments.push_back(segment);
    }
  }
  std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) { return s.lo_x() < t.lo_x(); });
  return segments;
}

double LargestOf(const std::vector<Segment>& segments) {
  double largest = 0;
  for (const Segment& s : segments) largest = std::max(largest, s.a.cwiseAbs().maxCoeff());
  return largest;
}

std::optional<Point2> Cross(const Segment& s, const Segment& t, double tolerance) {
  const double a = s.Beside(t.a), b = s.Beside(t.b), c = t.Beside(s.a), d = t.Beside(s.b);
  const auto parted = [&](double x, double y) { return std::min(x, y) < -tolerance && std::max(x, y) > tolerance; };
  if (!parted(a, b) || !parted(c, d)) return std::nullopt;
  return Point2(t.a + (t.b - t.a) * (a / (a - b)));
}

}  // namespace

std::optional<OutlineCrossing> FindCrossing(const PlanePolygon& polygon) {
  const std::vector<Segment> segments = SegmentsOf(polygon);
  const double tolerance = kTolerance * LargestOf(segments);
  std::vector<const Segment*> active;
  for (const Segment& segment : segments) {
    std::erase_if(active, [&](const Segment* other) { return other->hi_x() < segment.lo_x(); });
    for (const Segment* other : active) {
      if (!segment.SharesY(*other)) continue;
      const std::optional<Point2> at = Cross(*other, segment, tolerance);
      if (at) return OutlineCrossing{other->edge, segment.edge, *at};
    }
    active.push_back(&segment);
  }
  return std::nullopt;
}

std::string TextOf(const OutlineCrossing& crossing) {
  auto [first, second] = std::pair(crossing.first, crossing.second);
  if (std::pair(second.ring, second.point) < std::pair(first.ring, first.point)) std::swap(first, second);
  std::ostringstream text;
  text.precision(12);
  text << "ring " << first.ring << " crosses ";
  if (first.ring == second.ring) {
    text << "itself";
  } else {
    text << "ring " << second.ring;
  }
  text << " at (" << crossing.at.x() << ", " << crossing.at.y() << "), where the edges from positions " << first.point
       << " and " << second.point << " meet";
  return text.str();
}

}  // namespace tilemend
