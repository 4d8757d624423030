// The clusters whose surface is sampled as a whole, and which cells wait for them.
#ifndef TILEMEND_COORDINATOR_WAVES_CLUSTER_SAMPLING_H_
#define TILEMEND_COORDINATOR_WAVES_CLUSTER_SAMPLING_H_

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/waves/planned_scene.h"
#include "coordinator/waves/scene_outcome.h"
#include "coordinator/waves/scene_work.h"

namespace tilemend {

// For each cluster the cells whose fill needs its heights. They are those of its own holes, and those whose patches
// have a new vertex of its boundary. A tile that overlaps its neighbour may have one though no hole of the cluster lies
// in its cell.
//   holes_of           by cell, the holes to fill
//   holes_of_clusters  by cluster
// Cost O(n log n) in the holes' segments.
std::map<int32_t, std::set<CellId>> CellsThatAwait(const Plan& plan,
                                                   const std::map<CellId, std::vector<int32_t>>& holes_of,
                                                   const std::map<int32_t, std::vector<int32_t>>& holes_of_clusters);

// Pure; one thread at a time.
class ClusterSampling {
 public:
  ClusterSampling() = default;
  // Finds the clusters with holes to fill that are no water.
  explicit ClusterSampling(const PlannedScene& scene);

  std::vector<int32_t> LargestFirst(const Plan& plan) const;
  CellId FirstCellOf(int32_t cluster, const Plan& plan) const { return plan.holes[holes_of_.at(cluster)[0]].cell; }
  ClusterWork WorkOf(int32_t cluster, const PlannedScene& scene) const;
  // Settles the heights of the cluster. kInvalidArgument for a cluster that is not there, and as CheckSamples.
  absl::Status Take(const ClusterSamples& result, PlannedScene& scene, SceneOutcome& outcome);
  // Those of the cells that wait for the cluster that wait for no other any more. Call it once, after its Take.
  std::vector<CellId> Release(int32_t cluster);
  bool IsAwaitedBy(CellId cell) const { return clusters_left_.contains(cell); }
  // Whether all clusters have been taken, and each had a surface, so that nothing is left for the layers.
  bool IsOver() const { return with_surface_ == holes_of_.size(); }

 private:
  std::map<int32_t, std::vector<int32_t>> holes_of_;  // by cluster
  std::map<int32_t, std::set<CellId>> awaiting_;      // by cluster, the cells that await its surface
  std::map<CellId, int32_t> clusters_left_;           // of which a cell awaits the surface
  size_t with_surface_ = 0;                           // clusters that have been taken with one
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_CLUSTER_SAMPLING_H_
