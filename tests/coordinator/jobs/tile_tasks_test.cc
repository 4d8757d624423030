#include "coordinator/jobs/tile_tasks.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/coordinator/jobs/scene_tasks_fixture.h"

namespace tilemend {
namespace {

using TileTasksTest = SceneTasksFixture;

TEST_F(TileTasksTest, ATileHasItsDigestFromTheSurvey) {
  const auto inputs = Run();
  EXPECT_EQ(inputs.at(Stage::kSurvey).size(), waves_->scene().tiles.size());
  for (const std::string& bytes : inputs.at(Stage::kSurvey)) {
    EXPECT_EQ(Parsed<v1::SurveyInput>(bytes).tile().digest(), "");
  }
  for (const std::string& bytes : inputs.at(Stage::kAssemble)) {
    const v1::TileRef tile = Parsed<v1::AssembleInput>(bytes).tile();
    EXPECT_EQ(tile.digest().empty(), tile.path().empty()) << tile.path();
  }
}

TEST_F(TileTasksTest, GroundTasksNameTheRastersAround) {
  const auto inputs = Run();
  for (const std::string& bytes : inputs.at(Stage::kGround)) EXPECT_GT(Parsed<v1::GroundInput>(bytes).parts_size(), 0);
}

}  // namespace
}  // namespace tilemend
