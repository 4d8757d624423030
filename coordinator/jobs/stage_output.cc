#include "coordinator/jobs/stage_output.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/stage_words.h"

namespace tilemend {
namespace {

template <typename Message>
absl::StatusOr<StageOutput> ParseAs(const std::string& bytes) {
  Message message;
  if (!message.ParseFromString(bytes)) return absl::InvalidArgumentError("not the expected message");
  return StageOutput(std::move(message));
}

}  // namespace

absl::StatusOr<StageOutput> ParseStageOutput(Stage stage, const std::string& bytes) {
  switch (stage) {
    case Stage::kMeasure:
      return ParseAs<v1::MeasureOutput>(bytes);
    case Stage::kSurvey:
      return ParseAs<v1::SurveyOutput>(bytes);
    case Stage::kGround:
      return ParseAs<v1::GroundOutput>(bytes);
    case Stage::kSampleCluster:
      return ParseAs<v1::SampleClusterOutput>(bytes);
    case Stage::kSampleLayer:
      return ParseAs<v1::SampleLayerOutput>(bytes);
    case Stage::kFill:
      return ParseAs<v1::FillOutput>(bytes);
    case Stage::kSmoothSeam:
      return ParseAs<v1::SmoothSeamOutput>(bytes);
    case Stage::kAssemble:
      return ParseAs<v1::AssembleOutput>(bytes);
    case Stage::kVerify:
      break;
  }
  return absl::InternalError("unknown stage");
}

absl::StatusOr<StageResult> DecodeResult(TaskResult result, DecodedSurveys* surveys) {
  absl::StatusOr<StageOutput> output = ParseStageOutput(result.stage, *result.output);
  if (!output.ok()) return UnreadableResult(result.cell, output.status());
  std::optional<SurveyRecord> record;
  if (surveys != nullptr && result.stage == Stage::kSurvey) record = surveys->Take(*result.output);
  return StageResult{result.cell, result.stage, *std::move(result.output), *std::move(output), std::move(record)};
}

absl::Status UnreadableResult(CellId cell, const absl::Status& reason) {
  return absl::InternalError(
      absl::StrCat("a worker's result for cell ", ToString(cell), " cannot be read: ", std::string(reason.message())));
}

absl::Status InCell(CellId cell, Stage stage, const absl::Status& error) {
  if (!absl::IsInvalidArgument(error)) return error;
  absl::Status placed = absl::InvalidArgumentError(
      absl::StrCat("cell ", ToString(cell), ", ", StageWordsOf(StageName(stage)), ": ", std::string(error.message())));
  error.ForEachPayload([&](absl::string_view type, const absl::Cord& payload) { placed.SetPayload(type, payload); });
  return placed;
}

int32_t NumberOf(const StageOutput& output) {
  if (const auto* smoothed = std::get_if<v1::SmoothSeamOutput>(&output)) return smoothed->number();
  const auto* sampled = std::get_if<v1::SampleClusterOutput>(&output);
  return sampled != nullptr ? sampled->cluster() : 0;
}

bool IsUnchanged(const StageOutput& output) {
  if (const auto* surveyed = std::get_if<v1::SurveyOutput>(&output)) return surveyed->unchanged();
  const auto* assembled = std::get_if<v1::AssembleOutput>(&output);
  return assembled != nullptr && assembled->unchanged();
}

}  // namespace tilemend
