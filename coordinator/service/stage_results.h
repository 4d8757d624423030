// What workers' results say, as the waves of a scene take it.
#ifndef TILEMEND_COORDINATOR_SERVICE_STAGE_RESULTS_H_
#define TILEMEND_COORDINATOR_SERVICE_STAGE_RESULTS_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/records/survey_record.h"
#include "common/records/tile_files.h"
#include "coordinator/waves/scene_work.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

struct SurveyedTile {
  SurveyRecord record;
  TileFiles files;
  std::string digest;  // of the tile
};

// kInvalidArgument if the bytes are not the message.
absl::StatusOr<SurveyedTile> SurveyedTileOf(const std::string& survey_output);

// kInvalidArgument if columns are of unequal length, or a value is none that this release knows.
absl::StatusOr<ClusterSamples> SamplesOf(const v1::SampleClusterOutput& output);
absl::StatusOr<std::vector<SeamSample>> SamplesOf(const v1::SampleLayerOutput& output, CellId cell);
absl::StatusOr<CellPatches> PatchesOf(const v1::FillOutput& output);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_STAGE_RESULTS_H_
