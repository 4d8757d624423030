// The stages that look at a tile: its heights in polygons, and its survey.
#ifndef TILEMEND_WORKER_SERVICE_SURVEY_STAGE_H_
#define TILEMEND_WORKER_SERVICE_SURVEY_STAGE_H_

#include <string>

#include "absl/status/statusor.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/service/task_memory.h"

namespace tilemend {

// The bytes of a MeasureOutput: how much surface of the tile lies at which height in each polygon
// (common/mesh/height_tally.h). Errors of ReadFile and ParseMesh. Cost: linear in the tile, for each polygon.
absl::StatusOr<std::string> RunMeasure(const v1::MeasureInput& input, TaskMemory& memory);

// The bytes of a SurveyOutput: the record of the tile, of its ground raster, and of its look if that is asked for. All
// are without the surface that the tile's polygons take out. Says `unchanged` alone if the known survey still holds.
// Errors of ReadFile, ParseMesh and ClearTile. Cost: linear in the tile.
absl::StatusOr<std::string> RunSurvey(const v1::SurveyInput& input, TaskMemory& memory);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SERVICE_SURVEY_STAGE_H_
