#include "coordinator/jobs/sample_tasks.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/coordinator/jobs/scene_tasks_fixture.h"

namespace tilemend {
namespace {

using SampleTasksTest = SceneTasksFixture;

TEST_F(SampleTasksTest, NumbersOfVerticesAreTheTasksOwn) {
  const auto inputs = Run();
  for (const std::string& bytes : inputs.at(Stage::kSampleCluster)) {
    const auto input = Parsed<v1::SampleClusterInput>(bytes);
    EXPECT_LT(input.cluster(), 2);
    for (const int32_t vertex : input.holes().vertices().seam_vertex()) {
      EXPECT_LT(vertex, input.holes().vertices().seam_vertex_size());
    }
  }
}

TEST_F(SampleTasksTest, AVertexThatNoLayerAskedForIsNoResult) {
  Begin();
  v1::SampleLayerOutput output;
  output.add_seam_vertex(0);
  output.add_height(1);
  EXPECT_TRUE(absl::IsInternal(tasks_->Take({{0, 0}, Stage::kSampleLayer, "", output, {}})));
}

TEST_F(SampleTasksTest, AClusterThatWasNotAskedForIsNoResult) {
  Begin();
  EXPECT_TRUE(absl::IsInternal(tasks_->Take({{0, 0}, Stage::kSampleCluster, "", v1::SampleClusterOutput(), {}})));
}

}  // namespace
}  // namespace tilemend
