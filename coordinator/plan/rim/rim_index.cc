#include "coordinator/plan/rim/rim_index.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tilemend {
namespace {

constexpr int64_t kMaxBins = 1 << 22;

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

double SegmentDistance(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

}  // namespace

RimIndex::RimIndex(const Rim& rim) : rim_(rim), corners_(rim.points.size()) {
  Point2 hi{0, 0};
  if (!rim.edges.empty()) lo_ = hi = At(rim.edges[0].from);
  for (const RimEdge& e : rim.edges) {
    lo_ = lo_.cwiseMin(At(e.from)).cwiseMin(At(e.to));
    hi = hi.cwiseMax(At(e.from)).cwiseMax(At(e.to));
    mean_size_ += (At(e.to) - At(e.from)).norm();
  }
  mean_size_ = rim.edges.empty() ? 1 : std::max(mean_size_ / static_cast<double>(rim.edges.size()), 1e-6);
  const Point2 extent = hi - lo_;
  bin_ = std::max(4 * mean_size_, std::sqrt((extent.x() * extent.y() + 1) / static_cast<double>(kMaxBins)));
  bin_ = std::max(bin_, extent.maxCoeff() / (static_cast<double>(kMaxBins) / 4));
  columns_ = static_cast<int64_t>(extent.x() / bin_) + 1;
  rows_ = static_cast<int64_t>(extent.y() / bin_) + 1;
  const auto for_bins = [&](const RimEdge& e, auto&& visit) {
    const auto [c0, r0] = BinOf(At(e.from).cwiseMin(At(e.to)));
    const auto [c1, r1] = BinOf(At(e.from).cwiseMax(At(e.to)));
    for (int64_t r = r0; r <= r1; ++r) {
      for (int64_t c = c0; c <= c1; ++c) visit(static_cast<size_t>(r * columns_ + c));
    }
  };
  start_.assign(static_cast<size_t>(columns_ * rows_) + 1, 0);
  for (const RimEdge& e : rim.edges) for_bins(e, [&](size_t b) { ++start_[b + 1]; });
  for (size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
  items_.resize(static_cast<size_t>(start_.back()));
  std::vector<int32_t> fill(start_.begin(), start_.end() - 1);
  for (size_t i = 0; i < rim.edges.size(); ++i) {
    for_bins(rim.edges[i], [&](size_t b) { items_[static_cast<size_t>(fill[b]++)] = static_cast<int32_t>(i); });
  }
  for (const std::vector<int32_t>& loop : rim.loops) {
    for (size_t k = 0; k < loop.size(); ++k) {
      const int32_t point = rim.edges[loop[k]].to;
      corners_[static_cast<size_t>(point)].emplace_back(Before(loop, k), After(loop, k));
    }
  }
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

std::pair<int64_t, int64_t> RimIndex::BinOf(const Point2& p) const {
  const auto bin = [&](double d, int64_t n) {
    return std::clamp<int64_t>(static_cast<int64_t>(std::floor(std::clamp(d / bin_, -1.0, 1e9))), 0, n - 1);
  };
  return {bin(p.x() - lo_.x(), columns_), bin(p.y() - lo_.y(), rows_)};
}

std::vector<int32_t> RimIndex::EdgesIn(const Point2& lo, const Point2& hi) const {
  std::vector<int32_t> found;
  const auto [c0, r0] = BinOf(lo);
  const auto [c1, r1] = BinOf(hi);
  for (int64_t r = r0; r <= r1; ++r) {
    for (int64_t c = c0; c <= c1; ++c) {
      const auto b = static_cast<size_t>(r * columns_ + c);
      found.insert(found.end(), items_.begin() + start_[b], items_.begin() + start_[b + 1]);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

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
  for (const auto& [before, after] : corners_[static_cast<size_t>(point)]) {
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
    best = std::min(best, SegmentDistance(p, At(rim_.edges[i].from), At(rim_.edges[i].to)));
  }
  return best;
}

double RimIndex::SizeAt(const Point2& p, double growth, double limit) const {
  double best = limit;
  double radius = 4 * bin_;
  // Points farther than `radius` cannot give less than growth * radius: search wider until that is no gain.
  for (double done = 0; growth * done < best; done = radius, radius *= 2) {
    const Point2 reach = Point2::Constant(radius);
    for (const int32_t i : EdgesIn(p - reach, p + reach)) {
      const RimPoint& v = rim_.points[rim_.edges[i].from];
      best = std::min(best, v.size + growth * (v.position.head<2>() - p).norm());
    }
    if (radius > bin_ * static_cast<double>(columns_ + rows_) * 2) break;
  }
  return best;
}

bool RimIndex::InSurface(const Point2& p, double tolerance) const {
  if (Distance(p, 2 * tolerance) <= tolerance) return true;
  int winding = 0;
  const Point2 far(lo_.x() + bin_ * static_cast<double>(columns_), p.y());
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
