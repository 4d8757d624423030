#include "coordinator/plan/overlap/reached_holes.h"

#include <algorithm>
#include <map>
#include <set>

#include "common/mesh/disjoint_sets.h"

namespace tilemend {
namespace {

// Seen from above, by the segments to the east.
bool LiesIn(const Plan& plan, const PlannedHole& hole, const Point2& p) {
  bool inside = false;
  for (const RimSegment& s : hole.segments) {
    const Point3 &a = plan.vertices[s.from].position, &b = plan.vertices[s.to].position;
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    inside ^= a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x();
  }
  return inside;
}

std::vector<CellId> CellsBeside(CellId cell) {
  std::vector<CellId> cells;
  for (const int32_t col : {-1, 0, 1}) {
    for (const int32_t row : {-1, 0, 1}) {
      if (col != 0 || row != 0) cells.push_back({cell.col + col, cell.row + row});
    }
  }
  return cells;
}

std::set<int32_t> FarVertices(const Plan& plan, const PlannedHole& hole) {
  std::set<int32_t> far;
  for (const std::vector<RimSegment>& region : hole.own_regions) {
    for (const RimSegment& s : region) {
      if (IsFarOff(plan, s.from)) far.insert(s.from);
    }
  }
  return far;
}

}  // namespace

bool IsFarOff(const Plan& plan, int32_t vertex) {
  const PlanVertex& v = plan.vertices[vertex];
  if (v.index >= 0 || v.follows < 0) return false;
  return (v.position - plan.vertices[v.follows].position).head<2>().norm() > v.size / 2;
}

std::vector<std::pair<int32_t, int32_t>> HolesReached(const Plan& plan, const std::vector<bool>& open,
                                                      const std::vector<std::pair<int32_t, int32_t>>& touching) {
  std::multimap<CellId, int32_t> holes_of;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    if (open[h]) holes_of.emplace(plan.holes[h].cell, static_cast<int32_t>(h));
  }
  DisjointSets joined(static_cast<int32_t>(plan.holes.size()));
  for (const auto& [a, b] : touching) joined.Join(a, b);
  std::vector<std::pair<int32_t, int32_t>> reached;
  for (const auto& [cell, h] : holes_of) {
    const std::set<int32_t> far = FarVertices(plan, plan.holes[h]);
    for (const CellId beside : CellsBeside(cell)) {
      const auto [first, last] = holes_of.equal_range(beside);
      for (auto it = first; it != last; ++it) {
        const PlannedHole& other = plan.holes[it->second];
        if (joined.LowestOf(h) == joined.LowestOf(it->second) || other.water != plan.holes[h].water) continue;
        const auto lies_in = [&](int32_t v) { return LiesIn(plan, other, plan.vertices[v].position.head<2>()); };
        if (std::ranges::none_of(far, lies_in)) continue;
        joined.Join(h, it->second);
        reached.emplace_back(h, it->second);
      }
    }
  }
  std::ranges::sort(reached);
  return reached;
}

}  // namespace tilemend
