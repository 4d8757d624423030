#include "coordinator/plan/hole/hole_types.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/mesh/box_tree.h"
#include "common/mesh/edge_loops.h"
#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kCrackAngle_rad = 10.0 * std::numbers::pi / 180;  // Zhang 2022, 4.1 (1): 5 to 10 degrees
constexpr double kDislocation = 5e-4;                              // metres; Zhang 2022, 4.1 (2): 0.1 to 0.5 mm
// An inner loop that reaches this share of the outer one's way makes a ring: what reaches half of it does not because
// either is jagged.
constexpr double kAnnularReach = 0.6;

Point3 Centre(std::span<const RimSegment> loop, const std::vector<Point3>& position) {
  Point3 sum = Point3::Zero();
  for (const RimSegment& s : loop) sum += position[s.from];
  return sum / static_cast<double>(loop.size());
}

// From the middle to the vertices, in the mean. A length, or the farthest vertex, would count how jagged the loop is.
double Reach(std::span<const RimSegment> loop, const std::vector<Point3>& position) {
  const Point3 centre = Centre(loop, position);
  double sum = 0;
  for (const RimSegment& s : loop) sum += (position[s.from] - centre).norm();
  return sum / static_cast<double>(loop.size());
}

// Every edge within the threshold of the direction of the first, either way round.
bool IsCrack(std::span<const RimSegment> loop, const std::vector<Point3>& position) {
  const Eigen::Vector3d axis = (position[loop[0].to] - position[loop[0].from]).normalized();
  return std::all_of(loop.begin(), loop.end(), [&](const RimSegment& s) {
    const Eigen::Vector3d d = (position[s.to] - position[s.from]).normalized();
    return std::abs(d.dot(axis)) >= std::cos(kCrackAngle_rad);
  });
}

// Every vertex within the threshold of some edge that it is no end of. Cost: O(n log n) where few boxes of edges
// overlap.
bool IsDislocation(std::span<const RimSegment> loop, const std::vector<Point3>& position) {
  const auto is_near = [&](const RimSegment& v, const RimSegment& s) {
    return s.from != v.from && s.to != v.from &&
           DistanceToSegment(position[v.from], position[s.from], position[s.to]) < kDislocation;
  };
  // The first vertex of most holes is far from all other edges.
  if (std::ranges::none_of(loop, [&](const RimSegment& s) { return is_near(loop[0], s); })) return false;
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(loop.size());
  for (const RimSegment& s : loop) boxes.push_back(Eigen::AlignedBox3d(position[s.from]).extend(position[s.to]));
  const BoxTree edges(boxes);
  const Point3 reach = Point3::Constant(kDislocation);
  return std::ranges::all_of(loop, [&](const RimSegment& v) {
    const Point3& p = position[v.from];
    return edges.AnyMeeting({p - reach, p + reach}, [&](int32_t e) { return is_near(v, loop[e]); });
  });
}

// Place along the cell's outline, counter-clockwise from its south-west corner, in sides: [0, 4).
double OutlinePlace(const Point3& p, int side, const Point2& lo, const Point2& hi) {
  const double u = std::clamp((p.x() - lo.x()) / (hi.x() - lo.x()), 0.0, 1.0);
  const double v = std::clamp((p.y() - lo.y()) / (hi.y() - lo.y()), 0.0, 1.0);
  switch (side) {
    case kSouth:
      return u;
    case kEast:
      return 1 + v;
    case kNorth:
      return 2 + (1 - u);
    default:
      return std::fmod(3 + (1 - v), 4.0);
  }
}

struct Stretch {
  double begin, end;  // places on the outline, counter-clockwise
};

// Joins the segments along the outline to stretches. Empty if they go all the way round.
std::vector<Stretch> OutlineStretches(std::span<const BoundarySegment> segments, const Point2& lo, const Point2& hi,
                                      const std::vector<Point3>& position) {
  std::vector<BoundarySegment> along;
  std::vector<DirectedEdge> edges;
  for (const BoundarySegment& s : segments) {
    if (s.side < 0) continue;
    along.push_back(s);
    edges.push_back({s.segment.from, s.segment.to});
  }
  std::vector<Stretch> stretches;
  for (const EdgeWalk& walk : LinkEdges(edges)) {
    if (walk.closed) continue;
    const BoundarySegment &first = along[walk.edges.front()], &last = along[walk.edges.back()];
    stretches.push_back({OutlinePlace(position[first.segment.from], first.side, lo, hi),
                         OutlinePlace(position[last.segment.to], last.side, lo, hi)});
  }
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
  return stretches;
}

// How many sides the arc from a to b (counter-clockwise) touches with more than `tolerance` of a side.
int SidesTouched(double a, double b, double tolerance) {
  if (b <= a) b += 4;
  int count = 0;
  for (int side = 0; side < 4; ++side) {
    double along = 0;
    for (const double shift : {0.0, 4.0}) {
      along += std::max(0.0, std::min(b, side + 1 + shift) - std::max(a, side + shift));
    }
    count += along > tolerance;
  }
  return count;
}

}  // namespace

SingleType ClassifySingle(std::span<const RimSegment> outer, const std::vector<std::vector<RimSegment>>& islands,
                          const std::vector<Point3>& position) {
  if (islands.size() == 1) {
    const double reach = Reach(outer, position);
    const bool is_wide = Reach(islands[0], position) >= kAnnularReach * reach;
    if (is_wide && (Centre(islands[0], position) - Centre(outer, position)).norm() < reach) return SingleType::kAnnular;
  }
  if (!islands.empty()) return SingleType::kIsland;
  if (IsCrack(outer, position)) return SingleType::kCrack;
  if (IsDislocation(outer, position)) return SingleType::kDislocation;
  return SingleType::kSimple;
}

HoleType ClassifyOpen(std::span<const BoundarySegment> segments, CellId cell, bool has_surface, const GridLines& lines,
                      const std::vector<Point3>& position) {
  if (!has_surface) return HoleType::kA;
  const Point2 lo(lines.At(cell, kWest), lines.At(cell, kSouth));
  const Point2 hi(lines.At(cell, kEast), lines.At(cell, kNorth));
  const std::vector<Stretch> stretches = OutlineStretches(segments, lo, hi, position);
  constexpr double kTouch = 1e-4;     // of a side
  constexpr double kBackward = 0.05;  // of a side: two stretches of a ragged cut that overlap by less than this touch
  int parts = 0, least = 4;
  for (size_t i = 0; i < stretches.size(); ++i) {
    const double end = stretches[i].end, begin = stretches[(i + 1) % stretches.size()].begin;
    const double gap = std::fmod(begin - end + 8, 4.0);
    if (stretches.size() > 1 && (gap == 0 || gap > 4 - kBackward)) continue;
    const int sides = SidesTouched(end, begin, kTouch);
    if (sides == 0) continue;
    ++parts;
    least = std::min(least, sides);
  }
  if (parts <= 1) return HoleType::kB;
  return least >= 3 ? HoleType::kC : HoleType::kD;
}

}  // namespace tilemend
