// What workers' results say, as the waves of a scene take it.
#ifndef TILEMEND_COORDINATOR_JOBS_STAGE_RESULTS_H_
#define TILEMEND_COORDINATOR_JOBS_STAGE_RESULTS_H_

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/records/level_counts.h"
#include "common/records/survey_record.h"
#include "common/records/tile_files.h"
#include "coordinator/waves/scene_work.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

struct SurveyedTile {
  SurveyRecord record;
  TileFiles files;
  std::string digest;                    // of the tile
  std::string stamp;                     // likewise; may be empty
  std::vector<FileWitness::Read> reads;  // of its survey, beside the tile
  v1::GroundRasterBlob lowest;           // as it came
  std::vector<int64_t> cleared;          // triangles that each area took out
  std::vector<LevelCounts> levels;       // `nodes` of each
};

// `record`: that of the output, where it is known. kInvalidArgument for a record that is none.
absl::StatusOr<SurveyedTile> SurveyedTileOf(v1::SurveyOutput output, std::optional<SurveyRecord> record = {});

// A task for a cluster: its number in the plan, and the plan's numbers for those of its vertices.
struct AskedCluster {
  int32_t cluster = 0;
  std::vector<int32_t> seam_vertices;
};

// Numbers in results are local (coordinator/waves/local_numbers.h); here they become those of the plan.
// kInvalidArgument if one is out of range, columns are of unequal length, or a value is none that this release knows.
absl::StatusOr<ClusterSamples> SamplesOf(const v1::SampleClusterOutput& output, const AskedCluster& asked);
absl::StatusOr<std::vector<SeamSample>> SamplesOf(const v1::SampleLayerOutput& output, CellId cell,
                                                  const std::vector<int32_t>& seam_vertices);
absl::StatusOr<CellPatches> PatchesOf(const v1::FillOutput& output, const std::vector<int32_t>& holes);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_STAGE_RESULTS_H_
