#include "coordinator/plan/overlap/picture_edges.h"

#include <algorithm>

namespace tilemend {

PictureEdges::PictureEdges(const JointTiles& joint, CellId cell, const std::vector<int32_t>& vertices)
    : record_(*joint.own.at(cell)), chain_(joint.chain.at(cell)), square_(joint.squares.at(cell)) {
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

namespace {

// Of each segment the one that goes on from its end; none where several do, or none.
std::vector<std::optional<size_t>> NextOf(const std::vector<RimSegment>& segments) {
  std::map<int32_t, std::vector<size_t>> leaving;
  for (size_t i = 0; i < segments.size(); ++i) leaving[segments[i].from].push_back(i);
  std::vector<std::optional<size_t>> next;
  for (const RimSegment& s : segments) {
    const auto at = leaving.find(s.to);
    const bool is_one = at != leaving.end() && at->second.size() == 1;
    next.push_back(is_one ? std::optional(at->second[0]) : std::nullopt);
  }
  return next;
}

}  // namespace

std::vector<ChainPassage> PictureEdges::PassagesOf(const Plan& plan, const PlannedHole& hole) const {
  const std::vector<RimSegment>& segments = hole.segments;
  std::vector<std::optional<int32_t>> edge;
  for (const RimSegment& s : segments) edge.push_back(Under(s));
  const std::vector<std::optional<size_t>> next = NextOf(segments);
  const auto is_chain = [&](size_t i) { return edge[i] && chain_[*edge[i]]; };
  const auto is_line = [&](size_t i) { return !edge[i] && IsOnLine(plan, segments[i]); };
  const auto is_outline = [&](size_t i) { return !is_chain(i) && !is_line(i); };
  // The segment behind outlines of pieces that follow another. A part too short to tell its edge goes with them.
  const auto behind_outlines = [&](size_t i) {
    std::optional<size_t> k = next[i];
    for (size_t steps = 0; k && is_outline(*k); ++steps) k = steps < segments.size() ? next[*k] : std::nullopt;
    return k;
  };
  std::vector<ChainPassage> passages;
  for (size_t i = 0; i < segments.size(); ++i) {
    const std::optional<size_t> k = behind_outlines(i);
    if (!k || (!is_chain(i) && !is_chain(*k)) || is_outline(i)) continue;
    const int32_t from = segments[i].to, to = segments[*k].from;
    const bool is_along = k != next[i], crosses = through_.contains(from) && edge[i] != edge[*k];
    if (!is_along && (!edge[i] || !edge[*k] || !crosses)) continue;
    const auto place_at = [&](int32_t v) { return Point2(plan.vertices[v].position.head<2>()); };
    // The hole is walked around against the edges: a chain that comes first begins ahead.
    ChainPassage& passage = passages.emplace_back();
    if (is_chain(i)) passage.leaving = {*edge[i], place_at(from)};
    if (is_chain(*k)) passage.arriving = {*edge[*k], place_at(to)};
    if (is_line(i)) passage.at_outline = place_at(from);
    if (is_line(*k)) passage.at_outline = place_at(to);
  }
  return passages;
}

std::optional<int32_t> PictureEdges::Under(const RimSegment& s) const {
  if (s.seam) return std::nullopt;
  if (IsOwn(s.from) && IsOwn(s.to)) return Whole(s);
  for (const int32_t e : AtEnds(s)) {
    if (Passes(e, s.from) && Passes(e, s.to)) return e;
  }
  return std::nullopt;
}

bool PictureEdges::IsOnLine(const Plan& plan, const RimSegment& s) const {
  const Point3 &from = plan.vertices[s.from].position, &to = plan.vertices[s.to].position;
  return s.seam || std::ranges::any_of(kSides, [&](Side side) {
           return from[AxisOf(side)] == square_.side[side] && to[AxisOf(side)] == square_.side[side];
         });
}

bool PictureEdges::Passes(int32_t edge, int32_t v) const {
  const auto own = own_vertex_.find(v);
  if (own != own_vertex_.end()) return record_.edges[edge].from == own->second || record_.edges[edge].to == own->second;
  const auto through = through_.find(v);
  return through != through_.end() && std::ranges::find(through->second, edge) != through->second.end();
}

}  // namespace tilemend
