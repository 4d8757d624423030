#include "coordinator/plan/water/rim_chains.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "common/mesh/edge_loops.h"

namespace tilemend {
namespace {

std::vector<DirectedEdge> OriginalEdges(const Plan& plan, const std::vector<int32_t>& holes) {
  std::vector<DirectedEdge> edges;
  for (const int32_t h : holes) {
    for (const RimSegment& s : plan.holes[h].segments) {
      if (!s.seam && plan.vertices[s.from].index >= 0 && plan.vertices[s.to].index >= 0) {
        edges.push_back({s.from, s.to});
      }
    }
  }
  std::ranges::sort(edges, {}, [](const DirectedEdge& e) { return std::pair(e.from, e.to); });
  return edges;
}

// Where the walk around a rim begins depends on its cells, and the ends of a chain are judged by fewer edges.
void BeginAtLowestPlace(RimChain& chain) {
  const auto place = [](const ChainEdge& e) { return std::tuple(e.middle.x(), e.middle.y(), e.middle.z()); };
  std::ranges::rotate(chain, std::ranges::min_element(chain, {}, place));
}

}  // namespace

std::vector<RimChain> RimChainsOf(const Plan& plan, const std::vector<int32_t>& holes) {
  const std::vector<DirectedEdge> edges = OriginalEdges(plan, holes);
  std::vector<RimChain> chains;
  for (const EdgeWalk& walk : LinkEdges(edges)) {
    RimChain& chain = chains.emplace_back();
    for (const int32_t e : walk.edges) {
      const Point3 &a = plan.vertices[edges[e].from].position, &b = plan.vertices[edges[e].to].position;
      chain.push_back({(a + b) / 2, (b - a).head<2>().norm()});
    }
    if (walk.closed) BeginAtLowestPlace(chain);
  }
  return chains;
}

}  // namespace tilemend
