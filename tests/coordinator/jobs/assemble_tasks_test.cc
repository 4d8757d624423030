#include "coordinator/jobs/assemble_tasks.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/coordinator/jobs/scene_tasks_fixture.h"

namespace tilemend {
namespace {

using AssembleTasksTest = SceneTasksFixture;

TEST_F(AssembleTasksTest, WritesEachTileOnceWithThePatchesOfItsCell) {
  const auto inputs = Run();
  int filled = 0;
  for (const std::string& bytes : inputs.at(Stage::kAssemble)) {
    const auto input = Parsed<v1::AssembleInput>(bytes);
    EXPECT_EQ(input.has_patches(), input.has_vertices());
    filled += input.has_patches() ? 1 : 0;
  }
  EXPECT_EQ(filled, static_cast<int>(inputs.at(Stage::kFill).size()));
  EXPECT_EQ(TilesBelow(spec_.out()).size(), inputs.at(Stage::kAssemble).size());
  ExpectOriginalsKept(spec_.scene(), spec_.out());
}

TEST_F(AssembleTasksTest, HelpComesAfterTheInputThatItLeavesAsItIs) {
  Run();
  NewTask task{waves_->scene().tiles.front().cell, Stage::kAssemble, ""};
  ASSERT_TRUE(tasks_->AddHelp(task).ok());
  const auto help = Parsed<v1::AssembleInput>(task.input);
  EXPECT_FALSE(help.has_tile());
  NewTask survey{task.cell, Stage::kSurvey, "unchanged"};
  ASSERT_TRUE(tasks_->AddHelp(survey).ok());
  EXPECT_EQ(survey.input, "unchanged");
}

}  // namespace
}  // namespace tilemend
