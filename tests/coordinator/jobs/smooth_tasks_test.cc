#include "coordinator/jobs/smooth_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/coordinator/jobs/scene_tasks_fixture.h"

namespace tilemend {
namespace {

using SmoothTasksTest = SceneTasksFixture;

TEST_F(SmoothTasksTest, WhatMovesAtASeamGoesIntoTheTilesOfBothCells) {
  spec_.set_surface("wang");
  const auto inputs = Run();
  ASSERT_FALSE(inputs.at(Stage::kSmoothSeam).empty());
  const auto seam = Parsed<v1::SmoothSeamInput>(inputs.at(Stage::kSmoothSeam).front());
  EXPECT_GT(seam.a().holes_size(), 0);
  EXPECT_TRUE(seam.b().has_patches());
  EXPECT_EQ(seam.height_size(), seam.seam_vertex_size());
  int sides = 0;
  for (const std::string& bytes : inputs.at(Stage::kAssemble))
    sides += Parsed<v1::AssembleInput>(bytes).smoothed_size();
  EXPECT_EQ(sides, 2 * static_cast<int>(inputs.at(Stage::kSmoothSeam).size()));
}

TEST_F(SmoothTasksTest, ASeamThatWasNotAskedForIsNoResult) {
  Begin();
  EXPECT_TRUE(absl::IsInternal(tasks_->Take({{0, 0}, Stage::kSmoothSeam, "", v1::SmoothSeamOutput(), {}})));
}

}  // namespace
}  // namespace tilemend
