// Tasks that sample the surface at seam vertices.
#ifndef TILEMEND_COORDINATOR_JOBS_SAMPLE_TASKS_H_
#define TILEMEND_COORDINATOR_JOBS_SAMPLE_TASKS_H_

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/stage_results.h"
#include "coordinator/waves/scene_waves.h"
#include "tilemend/v1/job_spec.pb.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// The stage `sample`, of clusters and of layers. Keeps the plan's numbers for those in tasks.
class SampleTasks {
 public:
  // Both must outlive this. `options` are those of workers.
  SampleTasks(const v1::JobSpec& options, SceneWaves& waves) : options_(options), waves_(waves) {}

  absl::StatusOr<NewTask> TaskOf(ClusterWork& work);
  absl::StatusOr<NewTask> TaskOf(LayerWork& work);
  // Of the cell's cluster that was given out last: tells it from the others of the cell.
  int32_t LastClusterOf(CellId cell) const { return clusters_of_.at(cell) - 1; }

  // As SceneTasks::Take.
  absl::Status Take(CellId cell, const v1::SampleClusterOutput& output);
  absl::Status Take(CellId cell, const v1::SampleLayerOutput& output);

 private:
  const v1::JobSpec& options_;
  SceneWaves& waves_;
  std::map<CellId, int32_t> clusters_of_;                        // how many were given out, by the first cell of each
  std::map<std::pair<CellId, int32_t>, AskedCluster> clusters_;  // by first cell and number there
  std::map<CellId, std::vector<int32_t>> layers_;                // the plan's numbers of what is sampled
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SAMPLE_TASKS_H_
