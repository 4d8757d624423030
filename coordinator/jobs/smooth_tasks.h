// Tasks that smooth the patches on both sides of a seam.
#ifndef TILEMEND_COORDINATOR_JOBS_SMOOTH_TASKS_H_
#define TILEMEND_COORDINATOR_JOBS_SMOOTH_TASKS_H_

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/jobs/fill_tasks.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/store/scratch_file.h"
#include "coordinator/waves/scene_waves.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// The stage `smooth`. Keeps the points that move until their cell is assembled.
class SmoothTasks {
 public:
  // All must outlive this.
  SmoothTasks(const JobSpec& spec, SceneWaves& waves, std::shared_ptr<ScratchFile> scratch, const FillTasks& fills);

  absl::StatusOr<NewTask> TaskOf(SmoothWork& work);
  // The seam of the task that was made last.
  int32_t last_seam() const { return last_seam_; }
  // As SceneTasks::Take.
  absl::Status Take(CellId cell, const v1::SmoothSeamOutput& output);

  // Adds the points of the cell that move to the input, which has the cell's patches, and forgets them.
  absl::StatusOr<std::vector<std::vector<SmoothedPoint>>> MovePoints(CellId cell, v1::AssembleInput& input);

 private:
  absl::StatusOr<v1::SeamSide> SideOf(const CellHoles& cell, const std::vector<int32_t>& holes);

  const JobSpec& spec_;
  SceneWaves& waves_;
  const std::shared_ptr<ScratchFile> scratch_;
  const FillTasks& fills_;
  // What was asked, by the first cell and the number there; the points of each cell, by seam.
  std::map<std::pair<CellId, int32_t>, SmoothedSeam> seams_;
  int32_t last_seam_ = 0;
  std::map<CellId, std::map<std::pair<CellId, CellId>, ScratchFile::Place>> smoothed_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SMOOTH_TASKS_H_
