#include "coordinator/plan/rim/rim_index.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr int64_t kMaxBins = 1 << 22;
constexpr double kLeastMean = 1e-6;  // metres

double Cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Whether segments pq and ab meet anywhere, ends included.
bool Meet(const Point2& p, const Point2& q, const Point2& a, const Point2& b) {
  const double d1 = Cross(q - p, a - p), d2 = Cross(q - p, b - p);
  const double d3 = Cross(b - a, p - a), d4 = Cross(b - a, q - a);
  if (((d1 > 0 && d2 < 0) || (d1 < 0 && d2 > 0)) && ((d3 > 0 && d4 < 0) || (d3 < 0 && d4 > 0))) return true;
  const auto within = [](const Point2& u, const Point2& v, const Point2& w) {  // w on uv, known collinear
    return (w - u).dot(w - v) <= 0;
  };
  return (d1 == 0 && within(p, q, a)) || (d2 == 0 && within(p, q, b)) || (d3 == 0 && within(a, b, p)) ||
         (d4 == 0 && within(a, b, q));
}

Point2 PlaceOf(const Rim& rim, int32_t point) { return rim.points[point].position.head<2>(); }

// Seen from above; never zero.
double MeanLength(const Rim& rim) {
  double sum = 0;
  for (const RimEdge& e : rim.edges) sum += (PlaceOf(rim, e.to) - PlaceOf(rim, e.from)).norm();
  return rim.edges.empty() ? 1 : std::max(sum / static_cast<double>(rim.edges.size()), kLeastMean);
}

BinGrid BinsOf(const Rim& rim, double mean_size) {
  const auto box_of = [&](int32_t e) {
    const Point2 a = PlaceOf(rim, rim.edges[e].from), b = PlaceOf(rim, rim.edges[e].to);
    return Eigen::AlignedBox2d(a.cwiseMin(b), a.cwiseMax(b));
  };
  const auto count = static_cast<int32_t>(rim.edges.size());
  Eigen::AlignedBox2d extent;
  for (int32_t e = 0; e < count; ++e) extent.extend(box_of(e));
  if (extent.isEmpty()) extent.extend(Point2(0, 0));
  const Point2 sides = extent.sizes();
  const double most = static_cast<double>(kMaxBins);
  const double step =
      std::max({4 * mean_size, std::sqrt((sides.x() * sides.y() + 1) / most), sides.maxCoeff() / (most / 4)});
  return BinGrid(extent, step, count, box_of);
}

// Of the points where edges begin, each once.
GrownSizes SizesOf(const Rim& rim) {
  std::vector<bool> seen(rim.points.size(), false);
  std::vector<GrownSizes::Point> points;
  for (const RimEdge& e : rim.edges) {
    if (seen[e.from]) continue;
    seen[e.from] = true;
    points.push_back({PlaceOf(rim, e.from), rim.points[e.from].size});
  }
  return GrownSizes(std::move(points));
}

}  // namespace

RimIndex::RimIndex(const Rim& rim)
    : rim_(rim),
      mean_size_(MeanLength(rim)),
      bins_(BinsOf(rim, mean_size_)),
      sizes_(SizesOf(rim)),
      corners_(Corners()),
      corners_at_(rim.points.size(), [&rim](const auto& use) {
        int32_t corner = 0;
        for (const std::vector<int32_t>& loop : rim.loops) {
          for (const int32_t e : loop) use(rim.edges[e].to, corner++);
        }
      }) {}

// One for each edge of the loops, in order.
std::vector<std::pair<int32_t, int32_t>> RimIndex::Corners() const {
  std::vector<std::pair<int32_t, int32_t>> corners;
  for (const std::vector<int32_t>& loop : rim_.loops) {
    for (size_t k = 0; k < loop.size(); ++k) corners.emplace_back(Before(loop, k), After(loop, k));
  }
  return corners;
}

// The nearest point of the loop before (after) the end of edge k that does not lie at the same place seen from above.
int32_t RimIndex::Before(const std::vector<int32_t>& loop, size_t k) const {
  const Point2 here = At(rim_.edges[loop[k]].to);
  size_t i = k;
  for (size_t steps = 1; steps < loop.size() && At(rim_.edges[loop[i]].from) == here; ++steps) {
    i = (i + loop.size() - 1) % loop.size();
  }
  return rim_.edges[loop[i]].from;
}

int32_t RimIndex::After(const std::vector<int32_t>& loop, size_t k) const {
  const Point2 here = At(rim_.edges[loop[k]].to);
  size_t i = (k + 1) % loop.size();
  for (size_t steps = 1; steps < loop.size() && At(rim_.edges[loop[i]].to) == here; ++steps) i = (i + 1) % loop.size();
  return rim_.edges[loop[i]].to;
}

std::vector<int32_t> RimIndex::EdgesIn(const Point2& lo, const Point2& hi) const { return bins_.In({lo, hi}); }

int32_t RimIndex::EdgeBetween(int32_t a, int32_t b) const {
  for (const int32_t i : EdgesIn(At(a).cwiseMin(At(b)), At(a).cwiseMax(At(b)))) {
    const RimEdge& e = rim_.edges[i];
    if ((e.from == a && e.to == b) || (e.from == b && e.to == a)) return i;
  }
  return -1;
}

bool RimIndex::LeavesIntoHole(int32_t point, const Point2& direction) const {
  const auto angle = [](const Point2& d) { return std::atan2(d.y(), d.x()); };
  const auto turn = [](double a) { return a <= 0 ? a + 2 * std::numbers::pi : a; };
  for (const int32_t corner : corners_at_.Of(point)) {
    const auto& [before, after] = corners_[corner];
    const double back = angle(At(before) - At(point));
    const double whole = turn(angle(At(after) - At(point)) - back);
    const double part = turn(angle(direction) - back);
    if (part > 0 && part < whole) return true;
  }
  return false;
}

bool RimIndex::IsFree(const Point2& p, int32_t p_point, const Point2& q, int32_t q_point) const {
  if (p_point >= 0 && !LeavesIntoHole(p_point, q - p)) return false;
  if (q_point >= 0 && !LeavesIntoHole(q_point, p - q)) return false;
  for (const int32_t i : EdgesIn(p.cwiseMin(q), p.cwiseMax(q))) {
    const RimEdge& e = rim_.edges[i];
    // By place, not by number: the rim may have a vertical edge at an end.
    const bool at_p = p_point >= 0 && (At(e.from) == p || At(e.to) == p);
    const bool at_q = q_point >= 0 && (At(e.from) == q || At(e.to) == q);
    if (at_p && at_q) return false;  // the segment is this edge
    if (at_p || at_q) {              // only the edge's other end can lie on the segment
      const Point2 shared = at_p ? p : q;
      const Point2 other = At(e.from) == shared ? At(e.to) : At(e.from);
      if (other == shared) continue;
      if (Cross(q - p, other - p) == 0 && (other - p).dot(other - q) <= 0) return false;
      continue;
    }
    if (Meet(p, q, At(e.from), At(e.to))) return false;
  }
  return true;
}

double RimIndex::Distance(const Point2& p, double limit) const {
  double best = limit;
  const Point2 reach = Point2::Constant(limit);
  for (const int32_t i : EdgesIn(p - reach, p + reach)) {
    best = std::min(best, DistanceToSegment(p, At(rim_.edges[i].from), At(rim_.edges[i].to)));
  }
  return best;
}

bool RimIndex::InSurface(const Point2& p, double tolerance) const {
  if (Distance(p, 2 * tolerance) <= tolerance) return true;
  int winding = rim_.surface_beyond ? 1 : 0;
  const Point2 far(bins_.lo().x() + bins_.step() * static_cast<double>(bins_.columns()), p.y());
  for (const int32_t i : EdgesIn(p, far)) {
    const Point2 a = At(rim_.edges[i].from), b = At(rim_.edges[i].to);
    const double side = Cross(b - a, p - a);
    if (a.y() <= p.y() && b.y() > p.y() && side > 0) ++winding;
    if (a.y() > p.y() && b.y() <= p.y() && side < 0) --winding;
  }
  return winding > 0;
}

int32_t RimIndex::NearestPoint(const Point2& p, double radius) const {
  int32_t best = -1;
  double nearest = radius;
  const Point2 reach = Point2::Constant(radius);
  for (const int32_t i : EdgesIn(p - reach, p + reach)) {
    const int32_t v = rim_.edges[i].from;
    const double d = (At(v) - p).norm();
    if (d < nearest || (d == nearest && best >= 0 && v < best)) {
      nearest = d;
      best = v;
    }
  }
  return best;
}

}  // namespace tilemend
