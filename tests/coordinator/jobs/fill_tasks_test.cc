#include "coordinator/jobs/fill_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/coordinator/jobs/scene_tasks_fixture.h"

namespace tilemend {
namespace {

using FillTasksTest = SceneTasksFixture;

TEST_F(FillTasksTest, NumbersOfHolesAreTheTasksOwn) {
  const auto inputs = Run();
  ASSERT_GT(inputs.at(Stage::kFill).size(), 3U);
  for (const std::string& bytes : inputs.at(Stage::kFill)) {
    int32_t most = -1;
    const auto input = Parsed<v1::FillInput>(bytes);
    for (const v1::HoleBoundary& hole : input.holes().holes()) {
      EXPECT_LE(hole.id(), most + 1);
      most = std::max(most, hole.id());
    }
  }
}

TEST_F(FillTasksTest, WorkersGetTheirOptionsAlone) {
  spec_.set_filler("minimum-area");
  const auto inputs = Run();
  const v1::JobSpec options = Parsed<v1::FillInput>(inputs.at(Stage::kFill).front()).options();
  EXPECT_EQ(options.filler(), "minimum-area");
  EXPECT_EQ(options.scene(), "");
}

}  // namespace
}  // namespace tilemend
