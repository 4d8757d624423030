#include "coordinator/plan/overlap/picture_edges.h"

#include <algorithm>

namespace tilemend {

PictureEdges::PictureEdges(const JointTiles& joint, CellId cell, const std::vector<int32_t>& vertices)
    : record_(*joint.own.at(cell)) {
  const size_t own = record_.vertices.size();
  for (size_t v = 0; v < own; ++v) own_vertex_.emplace(vertices[v], static_cast<int32_t>(v));
  const std::vector<std::vector<int32_t>>& through = joint.edges_through.at(cell);
  for (size_t k = 0; k < through.size(); ++k) {
    std::vector<int32_t>& edges = through_[vertices[own + k]];
    edges.insert(edges.end(), through[k].begin(), through[k].end());
  }
  for (size_t e = 0; e < record_.edges.size(); ++e) {
    edge_.emplace(std::pair(record_.edges[e].from, record_.edges[e].to), static_cast<int32_t>(e));
  }
}

std::optional<int32_t> PictureEdges::Whole(const RimSegment& s) const {
  const auto from = own_vertex_.find(s.from), to = own_vertex_.find(s.to);
  if (from == own_vertex_.end() || to == own_vertex_.end()) return std::nullopt;
  const auto it = edge_.find({to->second, from->second});
  return it != edge_.end() ? std::optional(it->second) : std::nullopt;
}

std::vector<int32_t> PictureEdges::AtEnds(const RimSegment& s) const {
  std::vector<int32_t> edges;
  for (const int32_t v : {s.from, s.to}) {
    const auto it = through_.find(v);
    if (it != through_.end()) edges.insert(edges.end(), it->second.begin(), it->second.end());
  }
  return edges;
}

std::vector<EdgeCrossing> PictureEdges::CrossingsOf(const Plan& plan, const PlannedHole& hole) const {
  std::map<int32_t, std::vector<const RimSegment*>> leaving;
  for (const RimSegment& s : hole.segments) leaving[s.from].push_back(&s);
  std::vector<EdgeCrossing> crossings;
  for (const RimSegment& s : hole.segments) {
    const auto next = leaving.find(s.to);
    if (!through_.contains(s.to) || next == leaving.end() || next->second.size() != 1) continue;
    const std::optional<int32_t> before = Under(s), after = Under(*next->second[0]);
    if (!before || !after || *before == *after) continue;
    crossings.push_back({*after, *before, plan.vertices[s.to].position.head<2>()});
  }
  return crossings;
}

std::optional<int32_t> PictureEdges::Under(const RimSegment& s) const {
  if (s.seam) return std::nullopt;
  if (IsOwn(s.from) && IsOwn(s.to)) return Whole(s);
  for (const int32_t e : AtEnds(s)) {
    if (Passes(e, s.from) && Passes(e, s.to)) return e;
  }
  return std::nullopt;
}

bool PictureEdges::Passes(int32_t edge, int32_t v) const {
  const auto own = own_vertex_.find(v);
  if (own != own_vertex_.end()) return record_.edges[edge].from == own->second || record_.edges[edge].to == own->second;
  const auto through = through_.find(v);
  return through != through_.end() && std::ranges::find(through->second, edge) != through->second.end();
}

}  // namespace tilemend
