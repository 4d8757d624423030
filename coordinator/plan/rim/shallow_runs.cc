#include "coordinator/plan/rim/shallow_runs.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace tilemend {
namespace {

// Runs of at most this many edges may be longer than those beside them, and twice as deep.
constexpr size_t kShortRun = 2;

// Edges in a row that one cell closes on.
struct Run {
  size_t begin, length;  // begin may exceed the loop: taken modulo its size
};

// Whether the rim, going from a to b diagonally with the hole on its right, has `between` on that side.
bool PassesThrough(CellId a, CellId b, CellId between) { return AreDiagonal(a, b) && between == RightOfDiagonal(a, b); }

// The cell that a run of x between y and z lies in, if it is too shallow for x: y = z, or the one of them through which
// the rim passes to or from x across a corner. x itself if there is none.
CellId Around(CellId y, CellId x, CellId z) {
  if (y == z || PassesThrough(x, z, y)) return y;
  return PassesThrough(y, x, z) ? z : x;
}

class RunCloser {
 public:
  RunCloser(const PlanInput& input, const GridLines& lines, const Rim& rim, const std::vector<int32_t>& loop,
            std::vector<CellId>& closing)
      : input_(input), lines_(lines), rim_(rim), loop_(loop), closing_(closing) {}

  // Gives the first of the runs that can be given away to the cell around it. False if there is none.
  bool CloseOne() {
    const std::vector<Run> runs = FindRuns();
    std::optional<Run> best;
    CellId around_best;
    for (size_t r = 0; r < runs.size(); ++r) {
      const Run& before = runs[(r + runs.size() - 1) % runs.size()];
      const Run& after = runs[(r + 1) % runs.size()];
      const CellId own = CellAt(runs[r].begin), around = Around(CellAt(before.begin), own, CellAt(after.begin));
      if (around == own || !MayPass(runs[r], around)) continue;
      if (runs[r].length > std::max(kShortRun, std::min(before.length, after.length))) continue;
      if (best && !ComesFirst(runs[r], *best)) continue;
      if (!IsShallow(runs[r], around)) continue;
      best = runs[r];
      around_best = around;
    }
    if (!best) return false;
    for (size_t k = 0; k < best->length; ++k) CellAt(best->begin + k) = around_best;
    return true;
  }

 private:
  // Out of the area, and back, only at a zigzag: there what faces out is outline unless it is a tooth inside the line.
  // At the area's corners the outline may face now one way out and now the other: it passes the corner once.
  bool MayPass(const Run& run, CellId around) {
    const CellId own = CellAt(run.begin);
    if (InArea(own) && InArea(around)) return true;
    if (lines_.zigzag.empty()) return false;
    if (!InArea(own) && !InArea(around)) return true;
    if (InArea(own)) return true;
    return InArea(around) && run.length <= kShortRun && IsInside(run, around, own);
  }

  // Whether the run does not go over the line between two cells.
  bool IsInside(const Run& run, CellId cell, CellId across) {
    for (const Side side : kSides) {
      if (Across(cell, side) != across) continue;
      for (size_t k = run.begin; k < run.begin + run.length; ++k) {
        const RimEdge& e = rim_.edges[EdgeAt(k)];
        for (const int32_t p : {e.from, e.to}) {
          if (lines_.Inside(rim_.points[p].position, cell, side) <= kOnLine) return false;
        }
      }
      return true;
    }
    return false;
  }

  bool InArea(CellId cell) const { return input_.cells.contains(cell); }
  int32_t EdgeAt(size_t i) const { return loop_[i % loop_.size()]; }
  CellId& CellAt(size_t i) { return closing_[EdgeAt(i)]; }

  // Empty if one cell closes on all of the loop.
  std::vector<Run> FindRuns() {
    const size_t n = loop_.size();
    size_t start = 0;
    while (start < n && CellAt(start) == CellAt(start + n - 1)) ++start;
    std::vector<Run> runs;
    if (start == n) return runs;
    for (size_t i = start; i < start + n; ++i) {
      if (i == start || CellAt(i) != CellAt(i - 1)) runs.push_back({i, 0});
      ++runs.back().length;
    }
    return runs;
  }

  bool ComesFirst(const Run& a, const Run& b) const {
    if (a.length != b.length) return a.length < b.length;
    const Point3& p = rim_.points[rim_.edges[EdgeAt(a.begin)].from].position;
    const Point3& q = rim_.points[rim_.edges[EdgeAt(b.begin)].from].position;
    return std::tie(p.x(), p.y()) < std::tie(q.x(), q.y());
  }

  bool IsShallow(const Run& run, CellId around) {
    const double edges = run.length <= kShortRun ? 2 : 1;
    for (size_t k = run.begin; k < run.begin + run.length; ++k) {
      const RimEdge& e = rim_.edges[EdgeAt(k)];
      if (lines_.clipped && e.owner != CellAt(k)) return false;  // the tile ends here, with the hole beyond
      for (const int32_t p : {e.from, e.to}) {
        const double reach = lines_.clipped ? lines_.tolerance : edges * rim_.points[p].reach;
        if (!NearSquare(rim_.points[p].position, around, reach)) return false;
      }
    }
    return true;
  }

  // Whether p is in the square of `cell`, of the area or beside it, or within `reach` of it.
  bool NearSquare(const Point3& p, CellId cell, double reach) const {
    return std::all_of(kSides.begin(), kSides.end(), [&](Side side) {
      if (InArea(cell)) return lines_.Inside(p, cell, side) >= -reach;
      const double nominal = NominalLine(input_.grid, cell, side);
      return (nominal - p[AxisOf(side)]) * OutwardOf(side) >= -reach;
    });
  }

  const PlanInput& input_;
  const GridLines& lines_;
  const Rim& rim_;
  const std::vector<int32_t>& loop_;
  std::vector<CellId>& closing_;
};

}  // namespace

void CloseShallowRuns(const PlanInput& input, const GridLines& lines, const Rim& rim, const std::vector<int32_t>& loop,
                      std::vector<CellId>& closing) {
  RunCloser closer(input, lines, rim, loop, closing);
  while (closer.CloseOne()) {
  }
}

}  // namespace tilemend
