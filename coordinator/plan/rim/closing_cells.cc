#include "coordinator/plan/rim/closing_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "coordinator/plan/rim/shallow_runs.h"

namespace tilemend {
namespace {

// An edge belongs across when it faces the line at less than about 70 degrees.
constexpr double kFacing = 0.3;

// Whether the right-hand side of a -> b, where the hole lies, faces out over `side`.
bool Faces(const Point3& a, const Point3& b, Side side) {
  const Point2 d = (b - a).head<2>();
  const double out = (AxisOf(side) == 0 ? d.y() : -d.x()) * OutwardOf(side);
  return out >= kFacing * d.norm();
}

// The cell that closes on an edge by what the edge alone tells.
CellId ClosingCellOf(const RimEdge& e, const PlanInput& input, const GridLines& lines, const Rim& rim) {
  if (e.area_edge) return e.owner;
  const RimPoint& a = rim.points[e.from];
  const RimPoint& b = rim.points[e.to];
  CellId best = e.owner;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Side side : kSides) {
    const CellId across = Across(e.owner, side);
    const double da = lines.Inside(a.position, e.owner, side), db = lines.Inside(b.position, e.owner, side);
    const bool in_zigzag = input.cells.contains(across) || lines.zigzag.contains({e.owner, side});
    const bool ragged = !lines.clipped && in_zigzag;
    const double reach = ragged ? std::max({lines.tolerance, a.reach, b.reach}) : lines.tolerance;
    const double depth = std::max(std::abs(da), std::abs(db));
    const bool within = std::max(da, db) <= reach && (ragged || std::min(da, db) >= -std::max(reach, kOnLine));
    if (!within || !Faces(a.position, b.position, side) || depth >= nearest) continue;
    nearest = depth;
    best = across;
  }
  return best;
}

// An edge along a border.
struct Interval {
  double lo, hi;  // along the line
  int32_t edge;
};

// The length of an interval that others, in order and apart from each other, lie along.
double Overlap(const Interval& interval, const std::vector<Interval>& others) {
  auto o = std::lower_bound(others.begin(), others.end(), interval.lo,
                            [](const Interval& a, double lo) { return a.hi < lo; });
  double overlap = 0;
  for (; o != others.end() && o->lo < interval.hi; ++o) {
    overlap += std::min(o->hi, interval.hi) - std::max(o->lo, interval.lo);
  }
  return overlap;
}

// A stretch of border where two tiles both end at the line but their vertices differ by less than the tolerance is a
// hairline, with an edge of either tile on each side. All of it goes to the lower cell.
void CloseHairlines(const PlanInput& input, const GridLines& lines, const Rim& rim, ClosingCells& closing) {
  std::map<Border, std::array<std::vector<Interval>, 2>> along;  // edges of the lower and of the upper cell's tile
  for (size_t i = 0; i < rim.edges.size(); ++i) {
    const RimEdge& e = rim.edges[i];
    if (closing[i] == e.owner || !input.cells.contains(closing[i])) continue;
    const Border border = std::minmax(e.owner, closing[i]);
    const int axis = AxisAlong(border);
    const double a = rim.points[e.from].position[axis], b = rim.points[e.to].position[axis];
    along[border][e.owner == border.second].push_back({std::min(a, b), std::max(a, b), static_cast<int32_t>(i)});
  }
  for (auto& [border, tiles] : along) {
    for (auto& edges : tiles) {
      std::sort(edges.begin(), edges.end(), [](const Interval& a, const Interval& b) { return a.lo < b.lo; });
    }
    for (const int t : {0, 1}) {
      for (const Interval& i : tiles[t]) {
        if (Overlap(i, tiles[1 - t]) > lines.tolerance) closing[i.edge] = border.first;
      }
    }
  }
}

// Edges shorter than the tolerance cannot tell a side: each goes to the cell of the edge before it.
void FollowAtShortEdges(const PlanInput& input, const GridLines& lines, const Rim& rim,
                        const std::vector<int32_t>& loop, ClosingCells& closing) {
  const auto is_short = [&](int32_t e) {
    const RimEdge& edge = rim.edges[e];
    return (rim.points[edge.to].position - rim.points[edge.from].position).head<2>().norm() <= 2 * lines.tolerance;
  };
  const size_t n = loop.size();
  size_t start = 0;
  while (start < n && is_short(loop[start])) ++start;
  for (size_t i = start + 1; i < start + n; ++i) {
    const int32_t e = loop[i % n];
    if (is_short(e) && input.cells.contains(closing[e])) closing[e] = closing[loop[(i - 1) % n]];
  }
}

}  // namespace

ClosingCells FindClosingCells(const PlanInput& input, const GridLines& lines, const Rim& rim) {
  ClosingCells closing;
  closing.reserve(rim.edges.size());
  for (const RimEdge& e : rim.edges) closing.push_back(ClosingCellOf(e, input, lines, rim));
  if (lines.joined) return closing;
  if (lines.clipped) {
    CloseHairlines(input, lines, rim, closing);
    for (const std::vector<int32_t>& loop : rim.loops) FollowAtShortEdges(input, lines, rim, loop, closing);
  }
  for (const std::vector<int32_t>& loop : rim.loops) CloseShallowRuns(input, lines, rim, loop, closing);
  return closing;
}

void GiveBackNear(const PlanInput& input, const Rim& rim, std::span<const Point2> points, double reach,
                  ClosingCells& closing) {
  for (size_t i = 0; i < rim.edges.size(); ++i) {
    const RimEdge& e = rim.edges[i];
    if (closing[i] == e.owner || !input.cells.contains(closing[i])) continue;
    const Point2 p = rim.points[e.from].position.head<2>();
    if (std::any_of(points.begin(), points.end(), [&](const Point2& q) { return (p - q).norm() <= reach; })) {
      closing[i] = e.owner;
    }
  }
}

}  // namespace tilemend
