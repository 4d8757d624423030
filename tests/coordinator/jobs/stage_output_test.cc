#include "coordinator/jobs/stage_output.h"

#include <gtest/gtest.h>

#include <string>

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

TEST(StageOutputTest, SaysWhatIsUnchanged) {
  v1::SurveyOutput surveyed;
  surveyed.set_unchanged(true);
  v1::AssembleOutput assembled;
  assembled.set_unchanged(true);
  EXPECT_TRUE(IsUnchanged(StageOutput(surveyed)));
  EXPECT_TRUE(IsUnchanged(StageOutput(assembled)));
}

TEST(StageOutputTest, NamesTheCellOfBytesThatAreNoMessage) {
  const auto result = DecodeResult({{1, 2}, Stage::kFill, std::string("\xff\xff")});
  EXPECT_TRUE(absl::IsInternal(result.status()));
  EXPECT_NE(result.status().message().find(ToString(CellId{1, 2})), std::string::npos) << result.status();
}

}  // namespace
}  // namespace tilemend
