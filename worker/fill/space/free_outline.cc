#include "worker/fill/space/free_outline.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "common/records/moved_outline.h"

namespace tilemend {
namespace {

// For surface that faces up: a share of kMaxOutlineAside, as pieces of real tiles overlap by 0.095 m; metres that fills
// of overlapping tiles may be apart.
constexpr double kLevelShare = 0.4;
constexpr double kLevelRise = 0.02;

}  // namespace

FreeOutline::FreeOutline(const LocalHole& hole) : hole_(hole) {
  for (const auto& edge : hole.free_edges) {
    for (const int32_t v : {edge.first, edge.second}) {
      if (hole.vertices[v] >= 0 && hole.cell->vertices[hole.vertices[v]].index < 0) places_[v] = hole.positions[v];
    }
  }
  for (const RegionSegment& s : hole.segments) {
    if (std::ranges::binary_search(hole.free_edges, Undirected(s.from, s.to))) continue;
    places_.erase(s.from);
    places_.erase(s.to);
  }
}

bool FreeOutline::IsFreeEdge(int32_t a, int32_t b) const {
  const VertexPair edge = Undirected(a, b);
  if (edge.second >= hole_.size() || !std::ranges::binary_search(hole_.boundary, edge)) return true;
  return std::ranges::binary_search(hole_.free_edges, edge);
}

Point3 FreeOutline::PlannedPlace(int32_t v, const Point3& now) const {
  const auto there = places_.find(v);
  return there == places_.end() ? now : there->second;
}

bool FreeOutline::MayLie(const Point3& planned, const Point3& p, bool faces_up) {
  const double aside = (p - planned).head<2>().norm();
  const double rise = std::abs(p.z() - planned.z());
  return aside <= (faces_up ? kLevelShare : 1) * kMaxOutlineAside && rise <= (faces_up ? kLevelRise : kMaxOutlineRise);
}

bool FreeOutline::TellLeft(LocalPatch& patch) const {
  std::set<std::pair<int32_t, int32_t>> edges;
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
  }
  const auto placed = [&](int32_t from, int32_t to) -> PlacedEdge {
    const auto at = [&](int32_t v) {
      return v < hole_.size() ? hole_.positions[v] : patch.new_points[v - hole_.size()];
    };
    return {from, to, at(from), at(to)};
  };
  std::vector<PlacedEdge> lost, fresh;
  patch.left_edges.clear();
  std::set<std::pair<int32_t, int32_t>> boundary;
  for (const RegionSegment& s : hole_.segments) boundary.insert({s.from, s.to});
  for (const RegionSegment& s : hole_.segments) {
    // Two to and fro are closed by themselves.
    if (edges.contains({s.from, s.to}) || boundary.contains({s.to, s.from})) continue;
    lost.push_back(placed(s.from, s.to));
    patch.left_edges.push_back(Undirected(s.from, s.to));
  }
  std::ranges::sort(patch.left_edges);
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from}) && !boundary.contains({from, to})) fresh.push_back(placed(from, to));
  }
  return std::ranges::includes(hole_.free_edges, patch.left_edges) && MayMoveOutline(lost, fresh);
}

}  // namespace tilemend
