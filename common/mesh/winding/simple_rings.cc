#include "common/mesh/winding/simple_rings.h"

#include <algorithm>
#include <span>

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

}  // namespace

std::vector<std::vector<Point2>> SimpleRings(const std::vector<std::vector<Point2>>& rings, Wound wound) {
  const Millimetres lattice(rings);
  std::vector<Ring> rounded, turned;
  for (const std::vector<Point2>& ring : rings) {
    Ring& points = rounded.emplace_back();
    for (const Point2& p : ring) points.push_back(lattice.Round(p));
    turned.emplace_back(points.rbegin(), points.rend());
  }
  std::vector<Ring> simple = WoundRings(rounded);
  if (wound == Wound::kEither) {
    const std::vector<Ring> others = WoundRings(turned);
    simple.insert(simple.end(), others.begin(), others.end());
    simple = WoundRings(simple);  // where the two touch
  }
  std::vector<std::vector<Point2>> result;
  for (const Ring& ring : simple) {
    for (std::vector<Point2>& points = result.emplace_back(); const LatticePoint p : ring) {
      points.push_back(lattice.ToMetres(p));
    }
  }
  return result;
}

}  // namespace tilemend
