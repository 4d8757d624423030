#include "common/mesh/winding/simple_rings.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "common/mesh/edge_loops.h"
#include "common/mesh/lattice.h"
#include "common/mesh/winding/wound_region.h"

namespace tilemend {
namespace {

constexpr double kPerMetre = 1000;
constexpr double kMostSteps = 0x1p28;

using Ring = std::vector<LatticePoint>;

// Whole millimetres from one of the points, or more of them.
struct Millimetres {
  explicit Millimetres(const std::vector<std::vector<Point2>>& rings) {
    if (rings.empty()) return;
    Point2 lo = rings[0][0], hi = lo;
    for (const std::vector<Point2>& ring : rings) {
      for (const Point2& p : ring) {
        lo = lo.cwiseMin(p);
        hi = hi.cwiseMax(p);
      }
    }
    while ((hi - lo).maxCoeff() * kPerMetre > kMostSteps * step) step *= 2;
    base = (lo * kPerMetre / step).array().round();
  }
  LatticePoint Round(const Point2& p) const {
    const Point2 steps = (p * kPerMetre / step).array().round().matrix() - base;
    return {static_cast<int64_t>(steps.x()), static_cast<int64_t>(steps.y())};
  }
  Point2 ToMetres(LatticePoint p) const {
    return (base + Point2(static_cast<double>(p.x), static_cast<double>(p.y))) * step / kPerMetre;
  }

  double step = 1;
  Point2 base{0, 0};
};

// Corners of a region by their numbers, and its outline.
struct Outline {
  std::vector<LatticePoint> points;
  std::vector<DirectedEdge> edges;
};

Outline RegionOf(const std::vector<Ring>& rings) {
  Outline given;
  for (const Ring& ring : rings) {
    const auto first = static_cast<int32_t>(given.points.size()), size = static_cast<int32_t>(ring.size());
    for (int32_t i = 0; i < size; ++i) given.edges.push_back({first + i, first + (i + 1) % size});
    given.points.insert(given.points.end(), ring.begin(), ring.end());
  }
  WoundRegion region = FindWoundRegion(given.points, given.edges);
  for (const RegionCorner& corner : region.corners) given.points.push_back(corner.place);
  return {std::move(given.points), std::move(region.segments)};
}

// Of edges that go on from `edge`, the one that turns left most: the region between the two touches no others there.
int32_t LeftmostOf(const Outline& outline, int32_t edge, std::span<const int32_t> candidates) {
  const LatticePoint from = outline.points[outline.edges[edge].from], at = outline.points[outline.edges[edge].to];
  const auto end = [&](int32_t e) { return outline.points[outline.edges[e].to]; };
  return *std::max_element(candidates.begin(), candidates.end(), [&](int32_t a, int32_t b) {
    const bool a_left = Orientation(from, at, end(a)) > 0, b_left = Orientation(from, at, end(b)) > 0;
    return a_left != b_left ? b_left : Orientation(at, end(a), end(b)) > 0;
  });
}

std::vector<Ring> WoundRings(const std::vector<Ring>& rings) {
  const Outline outline = RegionOf(rings);
  std::vector<Ring> simple;
  for (const EdgeWalk& walk : LinkEdges(outline.edges, [&](int32_t edge, std::span<const int32_t> candidates) {
         return LeftmostOf(outline, edge, candidates);
       })) {
    std::vector<int32_t> vertices;
    for (const int32_t e : walk.edges) vertices.push_back(outline.edges[e].from);
    for (const std::vector<int32_t>& loop : CutWhereItTouches<int32_t>(vertices)) {
      for (Ring& ring = simple.emplace_back(); const int32_t v : loop) ring.push_back(outline.points[v]);
    }
  }
  return simple;
}

// Whether sides of a ring meet elsewhere than at the vertex of two neighbours.
class RingSides {
 public:
  explicit RingSides(const Ring& ring) : ring_(ring) {}

  // Also true if it takes too long to tell, as for a comb with long teeth along x.
  bool MayMeet() const {
    std::vector<size_t> sides(ring_.size()), active;
    std::iota(sides.begin(), sides.end(), size_t{0});
    std::ranges::sort(sides, {}, [&](size_t side) { return std::min(From(side).x, To(side).x); });
    for (size_t compared = 0; const size_t side : sides) {
      const int64_t x = std::min(From(side).x, To(side).x);
      std::erase_if(active, [&](size_t other) { return std::max(From(other).x, To(other).x) < x; });
      compared += active.size();
      if (compared > kMostCompared * ring_.size()) return true;
      if (std::ranges::any_of(active, [&](size_t other) { return Meet(side, other); })) return true;
      active.push_back(side);
    }
    return false;
  }

 private:
  static constexpr size_t kMostCompared = 64;  // for each side; the region of the ring takes as long as some hundred

  LatticePoint From(size_t side) const { return ring_[side]; }
  LatticePoint To(size_t side) const { return ring_[Next(side)]; }
  size_t Next(size_t side) const { return side + 1 == ring_.size() ? 0 : side + 1; }

  bool Meet(size_t s, size_t t) const {
    if (Next(t) == s) std::swap(s, t);
    const LatticePoint a = From(s), b = To(s), c = From(t), d = To(t);
    if (Next(s) == t) {
      return Orientation(a, b, d) == 0 && (b.x - a.x) * (d.x - c.x) + (b.y - a.y) * (d.y - c.y) <= 0;
    }
    const auto apart = [](int64_t p, int64_t q, int64_t u, int64_t v) {
      return std::max(p, q) < std::min(u, v) || std::max(u, v) < std::min(p, q);
    };
    if (apart(a.y, b.y, c.y, d.y) || apart(a.x, b.x, c.x, d.x)) return false;
    return Orientation(a, b, c) * Orientation(a, b, d) <= 0 && Orientation(c, d, a) * Orientation(c, d, b) <= 0;
  }

  const Ring& ring_;
};

// Precondition: its sides do not meet.
bool IsCounterClockwise(const Ring& ring) {
  const size_t lowest = std::ranges::min_element(ring) - ring.begin(), n = ring.size();
  return Orientation(ring[(lowest + n - 1) % n], ring[lowest], ring[(lowest + 1) % n]) > 0;
}

std::vector<Ring> WoundRings(const std::vector<Ring>& rings, Wound wound) {
  if (rings.size() == 1 && rings[0].size() > 2 && !RingSides(rings[0]).MayMeet()) {
    if (IsCounterClockwise(rings[0])) return rings;
    return wound == Wound::kLeft ? std::vector<Ring>() : std::vector<Ring>{{rings[0].rbegin(), rings[0].rend()}};
  }
  std::vector<Ring> simple = WoundRings(rings);
  if (wound == Wound::kLeft) return simple;
  std::vector<Ring> turned;
  for (const Ring& ring : rings) turned.emplace_back(ring.rbegin(), ring.rend());
  const std::vector<Ring> others = WoundRings(turned);
  simple.insert(simple.end(), others.begin(), others.end());
  return WoundRings(simple);  // where the two touch
}

}  // namespace

std::vector<std::vector<Point2>> SimpleRings(const std::vector<std::vector<Point2>>& rings, Wound wound) {
  const Millimetres lattice(rings);
  std::vector<Ring> rounded;
  for (const std::vector<Point2>& ring : rings) {
    for (Ring& points = rounded.emplace_back(); const Point2& p : ring) points.push_back(lattice.Round(p));
  }
  std::vector<std::vector<Point2>> result;
  for (const Ring& ring : WoundRings(rounded, wound)) {
    for (std::vector<Point2>& points = result.emplace_back(); const LatticePoint p : ring) {
      points.push_back(lattice.ToMetres(p));
    }
  }
  return result;
}

}  // namespace tilemend
