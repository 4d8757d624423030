// Tasks that write tiles.
#ifndef TILEMEND_COORDINATOR_JOBS_ASSEMBLE_TASKS_H_
#define TILEMEND_COORDINATOR_JOBS_ASSEMBLE_TASKS_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/records/level_counts.h"
#include "coordinator/jobs/fill_tasks.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/scene_files.h"
#include "coordinator/jobs/smooth_tasks.h"
#include "coordinator/jobs/tile_tasks.h"
#include "coordinator/store/output_folder.h"
#include "coordinator/waves/scene_waves.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// The results of earlier stages that go into the tiles.
struct TileContents {
  SceneFiles& files;
  std::vector<LevelCounts>& levels;
  const TileTasks& tiles;
  FillTasks& fills;
  SmoothTasks& seams;
};

// The stage `assemble`.
class AssembleTasks {
 public:
  // All must outlive this. `output` is null in a dry run, which assembles nothing.
  AssembleTasks(const JobSpec& spec, SceneWaves& waves, OutputFolder* output, const TileContents& contents)
      : spec_(spec), waves_(waves), output_(output), contents_(contents) {}

  absl::StatusOr<NewTask> TaskOf(AssembleWork& work);
  // As SceneTasks.
  absl::Status AddHelp(NewTask& task) const;
  absl::Status Take(CellId cell, const v1::AssembleOutput& output);

 private:
  absl::Status SetPatches(AssembleWork& work, v1::AssembleInput& input);
  void SetFiles(const SceneTile& tile, v1::AssembleInput& input);

  const JobSpec& spec_;
  SceneWaves& waves_;
  OutputFolder* const output_;
  const TileContents contents_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_ASSEMBLE_TASKS_H_
