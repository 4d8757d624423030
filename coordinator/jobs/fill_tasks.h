// Tasks that fill the holes of cells, and the patches until they are assembled.
#ifndef TILEMEND_COORDINATOR_JOBS_FILL_TASKS_H_
#define TILEMEND_COORDINATOR_JOBS_FILL_TASKS_H_

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/tile_tasks.h"
#include "coordinator/store/scratch_file.h"
#include "coordinator/waves/scene_waves.h"
#include "tilemend/v1/job_spec.pb.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Gives the patches of a cell to the search for gaps between patches, if it wants them. `moves`: of smoothed seams.
absl::Status AddToGaps(CellId cell, const v1::RimVertices& rims, const v1::FillOutput& output,
                       std::span<const std::vector<SmoothedPoint>> moves, SceneWaves& waves);

// The stage `fill`.
class FillTasks {
 public:
  // All must outlive this. `options` are those of workers.
  FillTasks(const v1::JobSpec& options, SceneWaves& waves, std::shared_ptr<ScratchFile> scratch,
            const TileTasks& tiles);

  absl::StatusOr<NewTask> TaskOf(FillWork& work);
  // As SceneTasks::Take.
  absl::Status Take(CellId cell, v1::FillOutput output);

  bool HasPatches(CellId cell) const { return patches_.contains(cell); }
  // The cell must have patches.
  absl::StatusOr<v1::FillOutput> PatchesOf(CellId cell) const;
  absl::StatusOr<v1::RimVertices> RimsOf(CellId cell) const;
  // The plan's numbers of the cell's holes.
  const std::vector<int32_t>& HolesOf(CellId cell) const { return holes_.at(cell); }

  // The cell's holes are not to be filled.
  void Forget(CellId cell) { rims_.erase(cell); }
  // The cell is assembled.
  void Release(CellId cell);

 private:
  const v1::JobSpec& options_;
  SceneWaves& waves_;
  const std::shared_ptr<ScratchFile> scratch_;
  const TileTasks& tiles_;
  std::map<CellId, std::vector<int32_t>> holes_;    // the plan's numbers
  std::map<CellId, std::vector<int32_t>> sampled_;  // the plan's numbers of the seam vertices
  std::map<CellId, ScratchFile::Place> rims_, patches_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_FILL_TASKS_H_
