#include "coordinator/plan/rim/closing_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

// An edge belongs across when it faces the line at less than about 70 degrees.
constexpr double kFacing = 0.3;
// Runs of at most this many edges may be longer than those beside them, and twice as deep.
constexpr size_t kShortRun = 2;

class Labeller {
 public:
  Labeller(const PlanInput& input, const CutLines& lines, Rim& rim) : input_(input), lines_(lines), rim_(rim) {}

  void Run() {
    for (RimEdge& e : rim_.edges) e.label = LabelOf(e);
    if (lines_.independent) return;
    if (lines_.clipped) {
      LabelHairlines();
      for (const std::vector<int32_t>& loop : rim_.loops) SkipShortEdges(loop);
    }
    for (const std::vector<int32_t>& loop : rim_.loops) Smooth(loop);
  }

 private:
  bool InArea(CellId cell) const { return input_.cells.contains(cell); }

  // Distance of a point to the inner side of a line of `cell`; negative beyond it.
  double Inside(const Point3& p, CellId cell, Side side) const {
    return (lines_.At(cell, side) - p[AxisOf(side)]) * OutwardOf(side);
  }

  CellId LabelOf(const RimEdge& e) const {
    const RimPoint& a = rim_.points[e.from];
    const RimPoint& b = rim_.points[e.to];
    CellId best = e.owner;
    double nearest = 1e300;
    for (const Side side : kSides) {
      const CellId across = Across(e.owner, side);
      const double da = Inside(a.position, e.owner, side), db = Inside(b.position, e.owner, side);
      const bool ragged = !lines_.independent && !lines_.clipped && InArea(across);
      const double reach = ragged ? std::max({lines_.tolerance, a.size, b.size}) : lines_.tolerance;
      const double depth = std::max(std::abs(da), std::abs(db));
      const bool within = std::max(da, db) <= reach && (ragged || std::min(da, db) >= -std::max(reach, kOnLine));
      if (!within || (!lines_.independent && !Faces(a.position, b.position, side)) || depth >= nearest) continue;
      nearest = depth;
      best = across;
    }
    return best;
  }

  // Whether the right-hand side of a -> b, where the hole lies, faces out over `side`.
  static bool Faces(const Point3& a, const Point3& b, Side side) {
    const Point2 d = (b - a).head<2>();
    const double out = (AxisOf(side) == 0 ? d.y() : -d.x()) * OutwardOf(side);
    return out >= kFacing * d.norm();
  }

  // A stretch of border where two tiles both end at the line but their vertices differ by less than the tolerance is a
  // hairline, with an edge of either tile on each side. All of it goes to the lower cell.
  void LabelHairlines() {
    using Border = std::pair<CellId, CellId>;
    struct Interval {
      double lo, hi;
      int32_t edge;
    };
    std::map<Border, std::array<std::vector<Interval>, 2>> along;  // edges of the lower and of the upper cell's tile
    for (size_t i = 0; i < rim_.edges.size(); ++i) {
      const RimEdge& e = rim_.edges[i];
      if (e.label == e.owner || !InArea(e.label)) continue;
      const Border border = std::minmax(e.owner, e.label);
      const int axis = e.owner.row == e.label.row ? 1 : 0;
      const double a = rim_.points[e.from].position[axis], b = rim_.points[e.to].position[axis];
      along[border][e.owner == border.second].push_back({std::min(a, b), std::max(a, b), static_cast<int32_t>(i)});
    }
    for (auto& [border, sides] : along) {
      for (auto& side : sides) {
        std::sort(side.begin(), side.end(), [](const Interval& a, const Interval& b) { return a.lo < b.lo; });
      }
      for (const int s : {0, 1}) {
        for (const Interval& i : sides[s]) {
          const auto& other = sides[1 - s];
          auto o = std::lower_bound(other.begin(), other.end(), i.lo,
                                    [](const Interval& a, double lo) { return a.hi < lo; });
          double overlap = 0;
          for (; o != other.end() && o->lo < i.hi; ++o) overlap += std::min(o->hi, i.hi) - std::max(o->lo, i.lo);
          if (overlap > lines_.tolerance) rim_.edges[i.edge].label = border.first;
        }
      }
    }
  }

  // Edges shorter than the tolerance cannot tell a side: each takes the label before it.
  void SkipShortEdges(const std::vector<int32_t>& loop) {
    const auto is_short = [&](int32_t e) {
      const RimEdge& edge = rim_.edges[e];
      return (rim_.points[edge.to].position - rim_.points[edge.from].position).head<2>().norm() <= 2 * lines_.tolerance;
    };
    const size_t n = loop.size();
    size_t start = 0;
    while (start < n && is_short(loop[start])) ++start;
    for (size_t i = start + 1; i < start + n; ++i) {
      RimEdge& e = rim_.edges[loop[i % n]];
      if (is_short(loop[i % n]) && InArea(e.label)) e.label = rim_.edges[loop[(i - 1) % n]].label;
    }
  }

  // Whether p is in the square of `cell` or within `reach` of it.
  bool NearSquare(const Point3& p, CellId cell, double reach) const {
    return std::all_of(kSides.begin(), kSides.end(), [&](Side side) { return Inside(p, cell, side) >= -reach; });
  }

  // Relabels runs that are too shallow for a hole of their own (on a clipped cut: slivers that a tile has along its
  // side): x between y and y, all of it within an edge of y's square and no longer than what is on either side of it.
  // Short runs first, so that they do not cut long ones in pieces.
  void Smooth(const std::vector<int32_t>& loop) {
    struct Run {
      size_t begin, length;  // begin may exceed the loop: taken modulo its size
    };
    const size_t n = loop.size();
    const auto label = [&](size_t i) -> CellId& { return rim_.edges[loop[i % n]].label; };
    for (bool changed = true; changed;) {
      changed = false;
      size_t start = 0;
      while (start < n && label(start) == label(start + n - 1)) ++start;
      if (start == n) return;
      std::vector<Run> runs;
      for (size_t i = start; i < start + n; ++i) {
        if (i == start || label(i) != label(i - 1)) runs.push_back({i, 0});
        ++runs.back().length;
      }
      size_t best = runs.size();
      for (size_t r = 0; r < runs.size(); ++r) {
        const Run& before = runs[(r + runs.size() - 1) % runs.size()];
        const Run& after = runs[(r + 1) % runs.size()];
        const CellId around = Around(label(before.begin), label(runs[r].begin), label(after.begin));
        if (around == label(runs[r].begin) || !InArea(around) || !InArea(label(runs[r].begin))) continue;
        if (runs[r].length > std::min(before.length, after.length) && runs[r].length > kShortRun) continue;
        if (best < runs.size() && !Before(loop, runs[r].begin, runs[r].length, runs[best].begin, runs[best].length))
          continue;
        if (Shallow(loop, runs[r].begin, runs[r].begin + runs[r].length, around)) best = r;
      }
      if (best == runs.size()) continue;
      const size_t end = runs[best].begin + runs[best].length;
      const CellId around = Around(label(runs[best].begin + n - 1), label(runs[best].begin), label(end));
      for (size_t k = 0; k < runs[best].length; ++k) label(runs[best].begin + k) = around;
      changed = true;
    }
  }

  // The cell that a run of label x between y and z lies in, if it is too shallow for x: y = z, or the one of them
  // through which the rim passes to or from x across a corner. x itself if there is none.
  static CellId Around(CellId y, CellId x, CellId z) {
    if (y == z || PassesThrough(x, z, y)) return y;
    return PassesThrough(y, x, z) ? z : x;
  }

  // Whether the rim, going from a to b diagonally with the hole on its right, has `between` on that side.
  static bool PassesThrough(CellId a, CellId b, CellId between) {
    const int32_t dc = b.col - a.col, dr = b.row - a.row;
    if (std::abs(dc) != 1 || std::abs(dr) != 1) return false;
    return between == (dc * dr > 0 ? CellId{a.col + dc, a.row} : CellId{a.col, a.row + dr});
  }

  bool Before(const std::vector<int32_t>& loop, size_t a, size_t la, size_t b, size_t lb) const {
    if (la != lb) return la < lb;
    const Point3& p = rim_.points[rim_.edges[loop[a % loop.size()]].from].position;
    const Point3& q = rim_.points[rim_.edges[loop[b % loop.size()]].from].position;
    return std::tie(p.x(), p.y()) < std::tie(q.x(), q.y());
  }

  bool Shallow(const std::vector<int32_t>& loop, size_t begin, size_t end, CellId around) const {
    const double edges = end - begin <= kShortRun ? 2 : 1;
    for (size_t k = begin; k < end; ++k) {
      const RimEdge& e = rim_.edges[loop[k % loop.size()]];
      if (lines_.clipped && e.owner != e.label) return false;  // the tile ends here, with the hole beyond
      for (const int32_t p : {e.from, e.to}) {
        if (!NearSquare(rim_.points[p].position, around,
                        lines_.clipped ? lines_.tolerance : edges * rim_.points[p].size))
          return false;
      }
    }
    return true;
  }

  const PlanInput& input_;
  const CutLines& lines_;
  Rim& rim_;
};

}  // namespace

void ResetLabelsNear(const PlanInput& input, const std::vector<Point2>& points, double reach, Rim& rim) {
  for (RimEdge& e : rim.edges) {
    if (e.label == e.owner || !input.cells.contains(e.label)) continue;
    const Point2 p = rim.points[e.from].position.head<2>();
    if (std::any_of(points.begin(), points.end(), [&](const Point2& q) { return (p - q).norm() <= reach; }))
      e.label = e.owner;
  }
}

void LabelEdges(const PlanInput& input, const CutLines& lines, Rim& rim) { Labeller(input, lines, rim).Run(); }

}  // namespace tilemend
