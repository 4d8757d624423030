// Tasks that read the tiles of a scene, and what their results tell of the files.
#ifndef TILEMEND_COORDINATOR_JOBS_TILE_TASKS_H_
#define TILEMEND_COORDINATOR_JOBS_TILE_TASKS_H_

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/records/level_counts.h"
#include "coordinator/jobs/job_pipeline.h"
#include "coordinator/jobs/scene_files.h"
#include "coordinator/jobs/stage_results.h"
#include "coordinator/store/scratch_file.h"
#include "coordinator/waves/scene_waves.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Where a tile lies, without what was surveyed of it.
v1::TileRef TileRefOf(const SceneTile& tile, const std::string& root);

// The stages `measure`, `survey` and `ground`. Keeps the digests of the files that were read, and the ground rasters.
class TileTasks {
 public:
  // All must outlive this. Surveys add to `files` and `levels`.
  TileTasks(const JobSpec& spec, SceneWaves& waves, std::shared_ptr<ScratchFile> scratch, SceneFiles& files,
            std::vector<LevelCounts>& levels);

  absl::StatusOr<NewTask> TaskOf(const MeasureWork& work) const;
  absl::StatusOr<NewTask> TaskOf(const SurveyWork& work) const;
  absl::StatusOr<NewTask> TaskOf(const GroundWork& work) const;

  // As SceneTasks::Take.
  absl::Status Take(CellId cell, const v1::MeasureOutput& output);
  absl::Status Take(CellId cell, absl::StatusOr<SurveyedTile> tile);
  absl::Status Take(CellId cell, const v1::GroundOutput& output);

  // The tile, with its digest if it is surveyed.
  absl::StatusOr<v1::TileRef> Ref(const SceneTile& tile) const;
  // SurveyOutput.stamp; "" if there is none.
  absl::StatusOr<std::string> StampOf(CellId cell) const;
  // Of a file beside the tiles as a survey read it; "" if none did.
  std::string FileDigestOf(const std::string& path) const;

 private:
  absl::StatusOr<v1::SurveyOutput> SurveyedOf(CellId cell) const;

  const JobSpec& spec_;
  SceneWaves& waves_;
  const std::shared_ptr<ScratchFile> scratch_;
  SceneFiles& files_;
  std::vector<LevelCounts>& levels_;
  std::map<CellId, ScratchFile::Place> surveyed_;    // digest and stamp of each tile
  std::map<CellId, InputPart> lowest_;               // the ground raster of each tile, until the plan
  std::map<std::string, std::string> file_digests_;  // by path
  std::map<CellId, std::string> measured_;           // digest of each tile that is measured, until its survey
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_TILE_TASKS_H_
