// Work on a scene as tasks for workers, and what workers say as results of that work.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_TASKS_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_TASKS_H_

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/records/level_counts.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/scene_files.h"
#include "coordinator/jobs/stage_output.h"
#include "coordinator/jobs/stage_results.h"
#include "coordinator/store/output_folder.h"
#include "coordinator/store/scratch_file.h"
#include "coordinator/waves/scene_waves.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Where a tile lies, without what was surveyed of it.
v1::TileRef TileRefOf(const SceneTile& tile, const std::string& root);

// Encodes the work of a SceneWaves and hands it the decoded results. Keeps between the two what neither of them does:
// the patches of cells that are not assembled yet, digests, the files that tiles name, and the plan's numbers for those
// in tasks (coordinator/waves/local_numbers.h).
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
  void Forget(CellId cell) { rims_.erase(cell); }

  const SceneFiles& files() const { return files_; }
  // What became of the levels of detail of the chosen tiles so far, the coarsest first.
  const std::vector<LevelCounts>& levels() const { return levels_; }

 private:
  absl::StatusOr<NewTask> Encode(const MeasureWork& work) const;
  absl::StatusOr<NewTask> Encode(const SurveyWork& work) const;
  absl::StatusOr<NewTask> Encode(const GroundWork& work) const;
  absl::StatusOr<NewTask> Encode(ClusterWork& work);
  absl::StatusOr<NewTask> Encode(LayerWork& work);
  absl::StatusOr<NewTask> Encode(FillWork& work);
  absl::StatusOr<NewTask> Encode(SmoothWork& work);
  absl::StatusOr<NewTask> Encode(AssembleWork& work);
  absl::Status SetPatches(AssembleWork& work, v1::AssembleInput& input);
  absl::StatusOr<v1::SeamSide> SideOf(const CellHoles& cell, const std::vector<int32_t>& holes);
  void SetFiles(const SceneTile& tile, v1::AssembleInput& input);
  absl::StatusOr<v1::TileRef> Ref(const SceneTile& tile) const;

  absl::Status TakeOutput(CellId cell, const v1::MeasureOutput& output);
  absl::Status TakeOutput(CellId cell, absl::StatusOr<SurveyedTile> tile);
  absl::Status TakeOutput(CellId cell, const v1::GroundOutput& output);
  absl::Status TakeOutput(CellId cell, const v1::SampleClusterOutput& output);
  absl::Status TakeOutput(CellId cell, const v1::SampleLayerOutput& output);
  absl::Status TakeOutput(CellId cell, v1::FillOutput output);
  absl::Status TakeOutput(CellId cell, const v1::SmoothSeamOutput& output);
  absl::Status TakeOutput(CellId cell, const v1::AssembleOutput& output);
  absl::Status ComparePatches(CellId cell, const v1::RimVertices& rims, const v1::FillOutput& output,
                              std::span<const std::vector<SmoothedPoint>> moves);

  const JobSpec& spec_;
  const v1::JobSpec shape_;
  SceneWaves& waves_;
  OutputFolder* const output_;
  const std::shared_ptr<ScratchFile> scratch_;
  SceneFiles files_;
  std::vector<LevelCounts> levels_;
  std::map<CellId, ScratchFile::Place> surveyed_;    // digest and stamp of each tile
  std::map<CellId, InputPart> lowest_;               // the ground raster of each tile, until the plan
  std::map<std::string, std::string> file_digests_;  // by path: what was read for surveys, beside the tiles
  std::map<CellId, int32_t> clusters_of_;            // how many were given out, by the first cell of each
  std::map<CellId, std::string> measured_;           // digest of each tile that is measured, until its survey
  std::map<std::pair<CellId, int32_t>, AskedCluster> clusters_;  // that are sampled, by first cell and number there
  std::map<CellId, std::vector<int32_t>> layers_;                // the plan's numbers of what is sampled
  // Of the cells that are filled, until they are assembled.
  std::map<CellId, std::vector<int32_t>> holes_;    // the plan's numbers
  std::map<CellId, std::vector<int32_t>> sampled_;  // the plan's numbers of the seam vertices
  std::map<CellId, ScratchFile::Place> rims_, patches_;
  // Of seams that are smoothed: what was asked, by the first cell and the number there, and the points of each cell
  // that move, by seam.
  std::map<std::pair<CellId, int32_t>, SmoothedSeam> seams_;
  int32_t last_seam_ = 0;  // its number
  std::map<CellId, std::map<std::pair<CellId, CellId>, ScratchFile::Place>> smoothed_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_TASKS_H_
