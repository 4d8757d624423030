#include "coordinator/waves/holes_of_cells.h"

#include <algorithm>

namespace tilemend {
namespace {

// Those of the segments, and those whose heights they follow.
void AddNewVertices(const Plan& plan, const std::vector<RimSegment>& segments, std::set<int32_t>& vertices) {
  for (const RimSegment& s : segments) {
    for (const int32_t end : {s.from, s.to}) {
      for (const int32_t v : {end, plan.vertices[end].follows}) {
        if (v >= 0 && plan.vertices[v].index < 0) vertices.insert(v);
      }
    }
  }
}

}  // namespace

std::map<CellId, std::vector<int32_t>> HolesToFill(const Plan& plan, const std::set<CellId>& chosen) {
  std::map<CellId, std::vector<int32_t>> holes_of;
  std::set<int32_t> clusters;  // that reach chosen cells
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    if (!hole.failure.empty()) continue;
    holes_of[hole.cell].push_back(static_cast<int32_t>(h));
    if (hole.cluster >= 0 && chosen.contains(hole.cell)) clusters.insert(hole.cluster);
  }
  if (chosen.empty()) return holes_of;
  for (auto& [cell, holes] : holes_of) {
    if (chosen.contains(cell)) continue;
    std::erase_if(holes, [&](int32_t h) { return !clusters.contains(plan.holes[h].cluster); });
  }
  std::erase_if(holes_of, [](const auto& of_cell) { return of_cell.second.empty(); });
  return holes_of;
}

std::set<CellId> CellsOf(const Plan& plan, const std::vector<int32_t>& holes) {
  std::set<CellId> cells;
  for (const int32_t h : holes) cells.insert(plan.holes[h].cell);
  return cells;
}

std::map<int32_t, std::set<CellId>> CellsThatAwait(const Plan& plan,
                                                   const std::map<CellId, std::vector<int32_t>>& holes_of,
                                                   const std::map<int32_t, std::vector<int32_t>>& holes_of_clusters) {
  std::map<int32_t, std::set<CellId>> awaiting;
  std::multimap<int32_t, int32_t> clusters_at;  // by new vertex
  for (const auto& [cluster, holes] : holes_of_clusters) {
    awaiting[cluster] = CellsOf(plan, holes);
    std::set<int32_t> vertices;
    for (const int32_t h : holes) AddNewVertices(plan, plan.holes[h].segments, vertices);
    for (const int32_t v : vertices) clusters_at.emplace(v, cluster);
  }
  for (const auto& [cell, holes] : holes_of) {
    std::set<int32_t> vertices;
    for (const int32_t h : holes) {
      AddNewVertices(plan, plan.holes[h].segments, vertices);
      AddNewVertices(plan, plan.holes[h].inner_edges, vertices);
      for (const std::vector<RimSegment>& region : plan.holes[h].own_regions) AddNewVertices(plan, region, vertices);
    }
    for (const int32_t v : vertices) {
      const auto [from, to] = clusters_at.equal_range(v);
      for (auto it = from; it != to; ++it) awaiting[it->second].insert(cell);
    }
  }
  return awaiting;
}

size_t SegmentsOf(const Plan& plan, const std::vector<int32_t>& holes) {
  size_t count = 0;
  for (const int32_t h : holes) count += plan.holes[h].segments.size();
  return count;
}

int32_t LastLayerOf(const Plan& plan, const std::vector<int32_t>& holes) {
  int32_t last = 1;
  for (const int32_t h : holes) {
    if (plan.holes[h].water < 0) last = std::max(last, plan.holes[h].layer);
  }
  return last;
}

}  // namespace tilemend
