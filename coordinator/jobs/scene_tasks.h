// Work on a scene as tasks for workers, and what workers say as results of that work.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_TASKS_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_TASKS_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/records/level_counts.h"
#include "coordinator/jobs/assemble_tasks.h"
#include "coordinator/jobs/fill_tasks.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/sample_tasks.h"
#include "coordinator/jobs/scene_files.h"
#include "coordinator/jobs/smooth_tasks.h"
#include "coordinator/jobs/stage_output.h"
#include "coordinator/jobs/tile_tasks.h"
#include "coordinator/store/output_folder.h"
#include "coordinator/store/scratch_file.h"
#include "coordinator/waves/scene_waves.h"

namespace tilemend {

// Encodes the work of a SceneWaves and hands it the decoded results. Each stage keeps between the two what the waves do
// not: the patches of cells that are not assembled yet, digests, the files that tiles name, and the plan's numbers for
// those in tasks (coordinator/waves/local_numbers.h).
class SceneTasks {
 public:
  // `output` is null in a dry run. All must outlive this.
  SceneTasks(const JobSpec& spec, SceneWaves& waves, OutputFolder* output, std::shared_ptr<ScratchFile> scratch);

  absl::StatusOr<NewTask> TaskOf(SceneWork& work);
  // Of the task that was made last: tells it from others of its cell and stage, as NumberOf of its output.
  int32_t NumberOf(const NewTask& task) const;

  // Adds to a task's input what may help to do it, and tells it from no other.
  absl::Status AddHelp(NewTask& task) const;

  // kInternal for a result that cannot be read; of an assemble task also the errors of placing its files. For a survey,
  // kInvalidArgument if the tile does not lie in its cell.
  absl::Status Take(StageResult result);
  // The cell's holes are not to be filled.
  void Forget(CellId cell) { fills_.Forget(cell); }

  const SceneFiles& files() const { return files_; }
  // What became of the levels of detail of the chosen tiles so far, the coarsest first.
  const std::vector<LevelCounts>& levels() const { return levels_; }

 private:
  const v1::JobSpec worker_options_;
  SceneFiles files_;
  std::vector<LevelCounts> levels_;
  TileTasks tiles_;
  SampleTasks samples_;
  FillTasks fills_;
  SmoothTasks seams_;
  AssembleTasks written_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_TASKS_H_
