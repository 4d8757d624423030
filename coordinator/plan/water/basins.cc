#include "coordinator/plan/water/basins.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace tilemend {
namespace {

std::vector<PlaneSegment> Together(const std::vector<std::vector<PlaneSegment>>& outlines) {
  std::vector<PlaneSegment> all;
  for (const std::vector<PlaneSegment>& outline : outlines) all.insert(all.end(), outline.begin(), outline.end());
  return all;
}

void Judge(double min_river, bool is_known_river, Basin& basin) {
  const std::vector<PlaneSegment> outline = Together(basin.outlines);
  basin.evidence = EvidenceOf(basin.rim, outline);
  basin.river.reset();
  if (!basin.evidence.is_enough() || !MayFall(basin.evidence)) return;
  const std::vector<Point2> axis = RiverAxis(basin.outlines, min_river);
  if (axis.size() > 1) basin.river = FindFall(axis, basin.rim, outline, basin.evidence, is_known_river);
}

Basin Joined(const Basin& a, const Basin& b, double min_river) {
  Basin joint = a;
  joint.members.insert(joint.members.end(), b.members.begin(), b.members.end());
  std::ranges::sort(joint.members);
  joint.outlines.insert(joint.outlines.end(), b.outlines.begin(), b.outlines.end());
  joint.rim.insert(joint.rim.end(), b.rim.begin(), b.rim.end());
  joint.area += b.area;
  Judge(min_river, a.river || b.river, joint);
  return joint;
}

bool IsNear(const Basin& part, const Basin& joint) {
  return std::abs(part.evidence.level - joint.evidence.level) <= kSigmas * part.evidence.sigma();
}

// Whether a basin whose own rim tells no level has its foot at that of both: there, as sure as that is, and far below
// most of its rim.
bool HasFootAt(const LevelEvidence& e, double level, const LevelEvidence& water) {
  const double above = e.second_percentile - level;
  return level <= e.median && above < (e.median - e.second_percentile) / 2 && CanBeOneLevel(above, water, {});
}

// Whether a basin alone has its water at that of the river.
bool IsReachOf(const FallingWater& river, const Basin& part) {
  const LevelEvidence above = EvidenceOf(AboveRiver(river.water, part.rim), {});
  const LevelEvidence& alone = part.river ? part.river->evidence : part.evidence;
  if (part.is_level()) return CanBeOneLevel(above.level, alone, {});
  return HasFootAt(above, 0, river.evidence);
}

bool IsOneWater(const Basin& a, const Basin& b, const Basin& joint) {
  if (joint.river) return IsReachOf(*joint.river, a) && IsReachOf(*joint.river, b);
  if (a.river || b.river) return false;
  if (a.is_level() && b.is_level()) return joint.is_level() && IsNear(a, joint) && IsNear(b, joint);
  const Basin &water = a.is_level() ? a : b, &other = a.is_level() ? b : a;
  return joint.evidence.agrees() && HasFootAt(other.evidence, joint.evidence.level, water.evidence);
}

// Where a basin is, for the search of others near it.
struct Extent {
  explicit Extent(const Basin& basin) : width(basin.Width()) {
    for (const std::vector<PlaneSegment>& outline : basin.outlines) {
      for (const auto& [a, b] : outline) {
        corners.push_back(a);
        box.extend(a);
      }
    }
  }

  std::vector<Point2> CornersIn(Eigen::AlignedBox2d other, double margin) const {
    other.min().array() -= margin;
    other.max().array() += margin;
    std::vector<Point2> inside;
    for (const Point2& p : corners) {
      if (other.contains(p)) inside.push_back(p);
    }
    return inside;
  }

  double width;  // metres
  Eigen::AlignedBox2d box;
  std::vector<Point2> corners;
};

Eigen::AlignedBox2d BoxOf(std::span<const Point2> points) {
  Eigen::AlignedBox2d box;
  for (const Point2& p : points) box.extend(p);
  return box;
}

// Lowers `gap` to the least distance between a point of `a` and one of `b`, if that is less. Halves the larger set, the
// half that is nearer first, where the boxes are not farther apart; reorders both.
void LowerGap(std::span<Point2> a, std::span<Point2> b, double& gap) {
  constexpr size_t kFewPairs = 256;
  if (a.size() < b.size()) std::swap(a, b);
  const Eigen::AlignedBox2d box = BoxOf(a), other = BoxOf(b);
  if (b.empty() || box.exteriorDistance(other) >= gap) return;
  if (a.size() * b.size() <= kFewPairs) {
    for (const Point2& p : a) {
      for (const Point2& q : b) gap = std::min(gap, (p - q).norm());
    }
    return;
  }
  const int axis = box.sizes().x() < box.sizes().y() ? 1 : 0;
  const auto middle = a.begin() + static_cast<std::ptrdiff_t>(a.size() / 2);
  std::nth_element(a.begin(), middle, a.end(), [axis](const Point2& p, const Point2& q) { return p[axis] < q[axis]; });
  std::span<Point2> near(a.begin(), middle), far(middle, a.end());
  if (BoxOf(far).exteriorDistance(other) < BoxOf(near).exteriorDistance(other)) std::swap(near, far);
  LowerGap(near, b, gap);
  LowerGap(far, b, gap);
}

// Between the corners of two outlines; none: it is wider than both together.
std::optional<double> GapBetween(const Extent& a, const Extent& b) {
  const double most = a.width + b.width;
  if (a.box.exteriorDistance(b.box) > most) return std::nullopt;
  std::vector<Point2> of_a = a.CornersIn(b.box, most), of_b = b.CornersIn(a.box, most);
  double gap = std::numeric_limits<double>::infinity();
  LowerGap(of_a, of_b, gap);
  return gap <= most ? std::optional(gap) : std::nullopt;
}

using Pair = std::tuple<double, size_t, size_t>;  // the gap, two basins

std::vector<Pair> NearPairs(const std::vector<Basin>& basins) {
  const std::vector<Extent> extents(basins.begin(), basins.end());
  std::vector<Pair> pairs;
  for (size_t i = 0; i < basins.size(); ++i) {
    for (size_t k = i + 1; k < basins.size(); ++k) {
      if (!basins[i].evidence.is_enough() || !basins[k].evidence.is_enough()) continue;
      if (const auto gap = GapBetween(extents[i], extents[k])) pairs.emplace_back(*gap, i, k);
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace

double Basin::Width() const {
  std::vector<PlaneSegment> segments = Together(outlines);
  for (auto& [a, b] : segments) {
    if (std::pair(b.x(), b.y()) < std::pair(a.x(), a.y())) std::swap(a, b);
  }
  const auto order = [](const PlaneSegment& s) {
    return std::tuple(s.first.x(), s.first.y(), s.second.x(), s.second.y());
  };
  std::ranges::sort(segments, {}, order);
  double length = 0;
  for (size_t i = 0; i < segments.size();) {
    size_t next = i + 1;
    while (next < segments.size() && order(segments[next]) == order(segments[i])) ++next;
    if (next == i + 1) length += (segments[i].second - segments[i].first).norm();  // seams occur twice
    i = next;
  }
  return length > 0 ? 2 * area / length : 0;
}

Basin MakeBasin(size_t number, std::vector<PlaneSegment> outline, std::vector<RimChain> rim, double area,
                double min_river, bool is_known_river) {
  return MakeBasin(std::vector{number}, {std::move(outline)}, std::move(rim), area, min_river, is_known_river);
}

Basin MakeBasin(std::vector<size_t> members, std::vector<std::vector<PlaneSegment>> outlines, std::vector<RimChain> rim,
                double area, double min_river, bool is_known_river) {
  Basin basin{std::move(members), std::move(outlines), std::move(rim), area, {}, {}};
  Judge(min_river, is_known_river, basin);
  return basin;
}

std::vector<Basin> JoinBasins(std::vector<Basin> basins, double min_river) {
  std::vector<size_t> joined_into(basins.size());
  for (size_t i = 0; i < basins.size(); ++i) joined_into[i] = i;
  for (const auto& [gap, i, k] : NearPairs(basins)) {
    const size_t a = joined_into[i], b = joined_into[k];
    if (a == b || !(basins[a].is_level() || basins[b].is_level())) continue;
    Basin joint = Joined(basins[a], basins[b], min_river);
    if (!IsOneWater(basins[a], basins[b], joint)) continue;
    basins[a] = std::move(joint);
    for (size_t& into : joined_into) {
      if (into == b) into = a;
    }
  }
  std::vector<Basin> result;
  for (size_t i = 0; i < basins.size(); ++i) {
    if (joined_into[i] == i) result.push_back(std::move(basins[i]));
  }
  return result;
}

}  // namespace tilemend
