#include "coordinator/waves/cluster_sampling.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "coordinator/plan/make_cell_holes.h"
#include "coordinator/waves/sample_checks.h"

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

std::set<CellId> CellsOf(const Plan& plan, const std::vector<int32_t>& holes) {
  std::set<CellId> cells;
  for (const int32_t h : holes) cells.insert(plan.holes[h].cell);
  return cells;
}

size_t SegmentsOf(const Plan& plan, const std::vector<int32_t>& holes) {
  size_t count = 0;
  for (const int32_t h : holes) count += plan.holes[h].segments.size();
  return count;
}

}  // namespace

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

ClusterSampling::ClusterSampling(const PlannedScene& scene) {
  for (const auto& [cell, holes] : scene.holes_of) {
    for (const int32_t h : holes) {
      const PlannedHole& hole = scene.plan.holes[h];
      if (hole.cluster >= 0 && hole.water < 0) holes_of_[hole.cluster].push_back(h);
    }
  }
  awaiting_ = CellsThatAwait(scene.plan, scene.holes_of, holes_of_);
  for (const auto& [cluster, cells] : awaiting_) {
    for (const CellId cell : cells) ++clusters_left_[cell];
  }
}

std::vector<int32_t> ClusterSampling::LargestFirst(const Plan& plan) const {
  std::vector<std::pair<size_t, int32_t>> clusters;
  for (const auto& [cluster, holes] : holes_of_) clusters.emplace_back(SegmentsOf(plan, holes), cluster);
  std::stable_sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<int32_t> sorted;
  for (const auto& [size, cluster] : clusters) sorted.push_back(cluster);
  return sorted;
}

ClusterWork ClusterSampling::WorkOf(int32_t cluster, const PlannedScene& scene) const {
  return {cluster, MakeCellHoles(scene.plan, scene.survey.input(), scene.heights, holes_of_.at(cluster), true)};
}

absl::Status ClusterSampling::Take(const ClusterSamples& result, PlannedScene& scene, SceneOutcome& outcome) {
  if (!holes_of_.contains(result.cluster)) {
    return absl::InvalidArgumentError(absl::StrCat("cluster ", result.cluster, " is not in the plan"));
  }
  if (absl::Status status = CheckSamples(scene.plan, result.samples); !status.ok()) return status;
  if (result.hold_out) {
    outcome.of_clusters[result.cluster] = *result.hold_out;
    scene.heights.tension[result.cluster] = result.hold_out->tension;
    if (result.hold_out->walls.is_told()) scene.heights.walls[result.cluster] = result.hold_out->walls;
  }
  if (!result.samples.empty()) ++with_surface_;
  SettleCluster(scene.plan, result.cluster, result.samples, scene.heights);
  return absl::OkStatus();
}

std::vector<CellId> ClusterSampling::Release(int32_t cluster) {
  std::vector<CellId> cells;
  for (const CellId cell : awaiting_.at(cluster)) {
    if (--clusters_left_[cell] == 0) cells.push_back(cell);
  }
  return cells;
}

}  // namespace tilemend
