#include "coordinator/plan/drop_vertices.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tilemend {
namespace {

// Calls `use` with every number of a vertex in the plan, but for those of boundary vertices.
template <class Use>
void ForNumbers(Plan& plan, Use use) {
  const auto use_ends = [&](std::vector<RimSegment>& segments) {
    for (RimSegment& s : segments) use(s.from), use(s.to);
  };
  for (PlannedHole& hole : plan.holes) {
    use_ends(hole.segments);
    for (std::vector<RimSegment>& region : hole.own_regions) use_ends(region);
    use_ends(hole.inner_edges);
  }
  for (Seam& seam : plan.seams) std::for_each(seam.vertices.begin(), seam.vertices.end(), use);
}

// Whether each vertex is used, by itself or by one that follows it.
std::vector<bool> UsedVertices(Plan& plan) {
  std::vector<bool> used(plan.vertices.size(), false);
  std::vector<int32_t> reached;
  const auto reach = [&](int32_t v) {
    if (!used[v]) reached.push_back(v);
    used[v] = true;
  };
  ForNumbers(plan, [&](const int32_t& v) { reach(v); });
  while (!reached.empty()) {
    const int32_t follows = plan.vertices[reached.back()].follows;
    reached.pop_back();
    if (follows >= 0) reach(follows);
  }
  return used;
}

// Takes the others away; gives the new number of each, -1 for those.
std::vector<int32_t> Compact(const std::vector<bool>& used, std::vector<PlanVertex>& vertices) {
  std::vector<int32_t> number(vertices.size(), -1);
  int32_t kept = 0;
  for (size_t v = 0; v < vertices.size(); ++v) {
    if (!used[v]) continue;
    number[v] = kept;
    vertices[kept++] = vertices[v];
  }
  vertices.resize(kept);
  vertices.shrink_to_fit();
  return number;
}

}  // namespace

void DropUnusedVertices(Plan& plan) {
  const std::vector<int32_t> number = Compact(UsedVertices(plan), plan.vertices);
  ForNumbers(plan, [&](int32_t& v) { v = number[v]; });
  for (PlanVertex& v : plan.vertices) v.follows = v.follows < 0 ? -1 : number[v.follows];
  for (auto& [cell, vertices] : plan.vertex_of_boundary) {
    for (int32_t& v : vertices) v = v < 0 ? -1 : number[v];
  }
  std::erase_if(plan.vertex_of_boundary, [](const auto& of_tile) {
    return std::ranges::all_of(of_tile.second, [](int32_t v) { return v < 0; });
  });
}

}  // namespace tilemend
