#include "coordinator/plan/water/area_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "coordinator/plan/water/line_intervals.h"

namespace tilemend {
namespace {

constexpr int kLines = 128;
constexpr double kSameLevel = 0.01;  // metres between levels that were given
constexpr double kRounding = 1e-9;   // a share of more areas is less by rounding alone, and by less than this

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

// What an area says but for its level: areas of which it differs say different things.
using Saying = std::tuple<bool, ReviewDecision, WaterKind, bool, bool>;
Saying SayingOf(const WaterArea& area) {
  return {area.water, area.decision, area.kind, area.clear, area.level.has_value()};
}

double LevelOf(const WaterArea& area) { return area.level.value_or(0); }

// How far the level of an area may be from that of another with a smaller tolerance.
double ToleranceOf(const WaterArea& area) {
  return area.level ? std::max(kSameLevel, area.level_sigma.value_or(0)) : 0;
}

bool CoversMore(const AreaShare& a, const AreaShare& b) {
  return a.share > b.share || (a.share == b.share && a.area < b.area);
}

// That which covers most; not of none.
AreaShare MostOf(std::span<const AreaShare> shares) {
  return *std::ranges::min_element(shares, CoversMore);  // the first in that order
}

// Finds, among areas none of which decides alone, the one that covers most of those that do so with what says the same.
class JointDecision {
 public:
  JointDecision(const CoverLines& region, std::span<const WaterArea> areas, const IsCancelled& is_cancelled)
      : region_(region), areas_(areas), is_cancelled_(is_cancelled) {}

  std::optional<DecidingArea> Find(std::span<const AreaShare> shares) {
    std::map<Saying, std::vector<AreaShare>> members_of;
    for (const AreaShare& s : shares) {
      if (areas_[s.area].centreline.empty()) members_of[SayingOf(areas_[s.area])].push_back(s);
    }
    for (const auto& [saying, members] : members_of) {
      std::vector<AreaShare> by_level = members;
      std::ranges::stable_sort(by_level, {}, [&](const AreaShare& s) { return LevelOf(areas_[s.area]); });
      Search(by_level, members);
    }
    return most_;
  }

 private:
  // Looks at candidates, which are in order of level. All that says the same as one of them is in `members`, in order.
  void Search(std::span<const AreaShare> candidates, std::span<const AreaShare> members) {
    const AreaShare best = MostOf(candidates);
    if ((is_cancelled_ && is_cancelled_()) || (most_ && !CoversMore(best, share_of_most_))) return;
    const std::vector<AreaShare> same = SayingTheSameAsAny(candidates, members);
    double sum = 0;
    for (const AreaShare& s : same) sum += s.share;
    if (sum <= kDecidingShare) return;
    std::vector<const WaterArea*> of_same;
    for (const AreaShare& s : same) of_same.push_back(&areas_[s.area]);
    const double share = region_.ShareIn(of_same, is_cancelled_);
    if (candidates.size() == 1 || AllSayTheSame(candidates, same)) {
      if (share <= kDecidingShare) return;
      most_ = DecidingArea{best.area, share, true};
      share_of_most_ = best;
      return;
    }
    if (share < kDecidingShare - kRounding) return;  // each covers less with its own
    auto first = candidates.first(candidates.size() / 2), second = candidates.subspan(candidates.size() / 2);
    if (CoversMore(MostOf(second), MostOf(first))) std::swap(first, second);
    Search(first, same);
    Search(second, same);
  }

  // Those whose level is near enough to the span of levels of the candidates. Exact for one candidate; of several it
  // may be more than say the same as any.
  std::vector<AreaShare> SayingTheSameAsAny(std::span<const AreaShare> candidates,
                                            std::span<const AreaShare> members) const {
    const double low = LevelOf(areas_[candidates.front().area]), high = LevelOf(areas_[candidates.back().area]);
    double tolerance = 0;
    for (const AreaShare& s : candidates) tolerance = std::max(tolerance, ToleranceOf(areas_[s.area]));
    std::vector<AreaShare> same;
    for (const AreaShare& s : members) {
      const WaterArea& area = areas_[s.area];
      const double off = std::max(LevelOf(area) - high, low - LevelOf(area));
      if (off <= std::max(tolerance, ToleranceOf(area))) same.push_back(s);
    }
    return same;
  }

  // Whether each candidate surely says the same as each of `same`.
  bool AllSayTheSame(std::span<const AreaShare> candidates, std::span<const AreaShare> same) const {
    const auto level = [&](const AreaShare& s) { return LevelOf(areas_[s.area]); };
    const auto [low, high] = std::ranges::minmax(same, {}, level);
    const double span = level(high) - level(low);
    return std::ranges::all_of(candidates, [&](const AreaShare& s) { return span <= ToleranceOf(areas_[s.area]); });
  }

  const CoverLines& region_;
  std::span<const WaterArea> areas_;
  const IsCancelled& is_cancelled_;
  std::optional<DecidingArea> most_;
  AreaShare share_of_most_;
};

}  // namespace

std::vector<PlaneSegment> SegmentsOf(const WaterArea& area) {
  std::vector<PlaneSegment> segments;
  for (const std::vector<Point2>& ring : area.polygon.rings) {
    for (size_t i = 0; i < ring.size(); ++i) segments.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  }
  return segments;
}

bool SayTheSame(const WaterArea& a, const WaterArea& b) {
  if (SayingOf(a) != SayingOf(b) || !a.centreline.empty() || !b.centreline.empty()) return false;
  return std::abs(LevelOf(a) - LevelOf(b)) <= std::max(ToleranceOf(a), ToleranceOf(b));
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

double CoverLines::ShareIn(std::span<const WaterArea* const> areas, const IsCancelled& is_cancelled) const {
  struct Outline {
    std::vector<PlaneSegment> segments;
    Bounds box;
  };
  std::vector<Outline> outlines;
  for (const WaterArea* area : areas) {
    outlines.push_back({SegmentsOf(*area), {}});
    outlines.back().box = BoundsOf(outlines.back().segments);
  }
  double common = 0;
  for (const Line& line : lines_) {
    if (is_cancelled && is_cancelled()) return 0;
    std::vector<std::pair<double, double>> parts;
    for (const Outline& outline : outlines) {
      if (line.y < outline.box.lo.y() || line.y > outline.box.hi.y()) continue;
      const std::vector<double> at = Crossings(outline.segments, line.y);
      for (size_t i = 0; i + 1 < at.size(); i += 2) parts.emplace_back(at[i], at[i + 1]);
    }
    common += CommonLength(line.inside, UnionOf(std::move(parts)));
  }
  return length_ > 0 ? common / length_ : 0;
}

std::optional<DecidingArea> FindDecidingArea(const CoverLines& region, std::span<const AreaShare> shares,
                                             std::span<const WaterArea> areas, const IsCancelled& is_cancelled) {
  for (size_t i = shares.size(); i-- > 0;) {
    if (shares[i].share > kDecidingShare) return DecidingArea{shares[i].area, shares[i].share, false};
  }
  return JointDecision(region, areas, is_cancelled).Find(shares);
}

}  // namespace tilemend
