#include "coordinator/jobs/stage_output.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "common/util/error_info.h"

namespace tilemend {
namespace {

TEST(StageOutputTest, IsTheMessageOfItsStage) {
  for (const Stage stage : kAllStages) {
    if (stage == Stage::kVerify) continue;  // no work of the scene
    const auto output = ParseStageOutput(stage, "");
    ASSERT_TRUE(output.ok()) << StageName(stage);
    EXPECT_EQ(NumberOf(*output), 0);
    EXPECT_FALSE(IsUnchanged(*output));
  }
  EXPECT_TRUE(std::holds_alternative<v1::FillOutput>(*ParseStageOutput(Stage::kFill, "")));
  for (const Stage other : {Stage::kVerify, static_cast<Stage>(99)}) {
    EXPECT_TRUE(absl::IsInternal(ParseStageOutput(other, "").status()));
  }
}

TEST(StageOutputTest, TellsResultsOfOneCellApart) {
  v1::SampleClusterOutput sampled;
  sampled.set_cluster(3);
  v1::SmoothSeamOutput smoothed;
  smoothed.set_number(4);
  EXPECT_EQ(NumberOf(StageOutput(sampled)), 3);
  EXPECT_EQ(NumberOf(StageOutput(smoothed)), 4);
}

TEST(StageOutputTest, AWrongInputNamesItsCell) {
  const absl::Status wrong = WithErrorInfo(absl::InvalidArgumentError("malformed"), {"A_REASON", {}});
  const absl::Status placed = InCell({1, 2}, Stage::kFill, wrong);
  EXPECT_TRUE(absl::IsInvalidArgument(placed));
  EXPECT_EQ(placed.message(), "cell +001_+002, fill the holes: malformed");
  EXPECT_EQ(ErrorReason(placed), "A_REASON");
  const absl::Status full = absl::ResourceExhaustedError("/mnt: the disk is full");
  EXPECT_EQ(InCell({1, 2}, Stage::kFill, full), full);
}

TEST(StageOutputTest, SaysWhatIsUnchanged) {
  v1::SurveyOutput surveyed;
  surveyed.set_unchanged(true);
  v1::AssembleOutput assembled;
  assembled.set_unchanged(true);
  EXPECT_TRUE(IsUnchanged(StageOutput(surveyed)));
  EXPECT_TRUE(IsUnchanged(StageOutput(assembled)));
}

TEST(StageOutputTest, TakesTheRecordThatTheCheckHasDecoded) {
  v1::SurveyOutput output;
  output.set_digest("a digest");
  const std::string bytes = output.SerializeAsString();
  const auto decode = [&](Stage stage, DecodedSurveys* surveys) {
    return DecodeResult({{1, 2}, stage, bytes}, surveys);
  };
  DecodedSurveys surveys;
  SurveyRecord record;
  record.triangle_count = 7;
  surveys.Put(bytes, record);
  EXPECT_FALSE(decode(Stage::kMeasure, &surveys)->record) << "a result of another stage";
  EXPECT_FALSE(decode(Stage::kSurvey, nullptr)->record);
  const auto result = decode(Stage::kSurvey, &surveys);
  ASSERT_TRUE(result.ok() && result->record);
  EXPECT_EQ(result->record->triangle_count, 7);
  EXPECT_EQ(std::get<v1::SurveyOutput>(result->output).digest(), "a digest");
  EXPECT_FALSE(decode(Stage::kSurvey, &surveys)->record) << "it was taken";
}

TEST(StageOutputTest, NamesTheCellOfBytesThatAreNoMessage) {
  const auto result = DecodeResult({{1, 2}, Stage::kFill, std::string("\xff\xff")});
  EXPECT_TRUE(absl::IsInternal(result.status()));
  EXPECT_NE(result.status().message().find(ToString(CellId{1, 2})), std::string::npos) << result.status();
}

}  // namespace
}  // namespace tilemend
