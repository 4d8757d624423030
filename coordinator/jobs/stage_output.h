// What a worker gave for a task of a scene, decoded once.
#ifndef TILEMEND_COORDINATOR_JOBS_STAGE_OUTPUT_H_
#define TILEMEND_COORDINATOR_JOBS_STAGE_OUTPUT_H_

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/grid/scene.h"
#include "common/util/stage.h"
#include "coordinator/jobs/decoded_surveys.h"
#include "coordinator/jobs/job_pipeline.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

using StageOutput = std::variant<v1::MeasureOutput, v1::SurveyOutput, v1::GroundOutput, v1::SampleClusterOutput,
                                 v1::SampleLayerOutput, v1::FillOutput, v1::SmoothSeamOutput, v1::AssembleOutput>;

// The message of a stage of the scene's work. kInvalidArgument if the bytes are not that message, kInternal for another
// stage.
absl::StatusOr<StageOutput> ParseStageOutput(Stage stage, const std::string& bytes);

struct StageResult {
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string bytes;
  StageOutput output;                  // of the bytes
  std::optional<SurveyRecord> record;  // of a survey, where it is known
};

// `result` is one of a task that was done. `surveys`, if given, may have the record of a survey. kInternal if the
// bytes are not the message of the stage.
absl::StatusOr<StageResult> DecodeResult(TaskResult result, DecodedSurveys* surveys = nullptr);

// kInternal, with the reason.
absl::Status UnreadableResult(CellId cell, const absl::Status& reason);

// The error of a task that could not be done. What is wrong with its input, kInvalidArgument, names no place by itself:
// the cell and what was done there come before it. The reason for programs stays.
absl::Status InCell(CellId cell, Stage stage, const absl::Status& error);

// The number that tells this result from others of its cell and stage.
int32_t NumberOf(const StageOutput& output);

// Whether the worker says that what an earlier job left is as it was: a survey, or the files of an assembly.
bool IsUnchanged(const StageOutput& output);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_STAGE_OUTPUT_H_
