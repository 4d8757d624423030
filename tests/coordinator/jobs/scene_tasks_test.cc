#include "coordinator/jobs/scene_tasks.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "common/options/job_options.h"
#include "coordinator/jobs/scene_options.h"
#include "tests/support/output_checks.h"
#include "tests/support/temporary_folder.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

// The inputs of all tasks of a scene but those that write, by stage.
std::map<Stage, std::vector<std::string>> InputsOf(const std::string& folder) {
  JobSpec spec = WithDefaults({});
  spec.set_scene(folder);
  SceneWaves waves(
      LoadScene(folder, [](const std::string&, const TileFrame&) { return absl::UnimplementedError(""); }).value(),
      WaveOptionsOf(spec, {}, [] { return false; }));
  SceneTasks tasks(spec, waves, nullptr, ScratchFile::Create("").value());
  std::map<Stage, std::vector<std::string>> inputs;
  std::vector<NewTask> open;
  do {
    while (auto work = waves.Next()) {
      if (std::holds_alternative<AssembleWork>(*work)) return inputs;
      open.push_back(tasks.TaskOf(*work).value());
      inputs[open.back().stage].push_back(open.back().input);
    }
    const NewTask task = open.back();
    open.pop_back();
    const absl::Status taken = tasks.Take(
        DecodeResult({task.cell, task.stage, SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken())})
            .value());
    EXPECT_TRUE(taken.ok()) << taken;
  } while (!open.empty() || !waves.done());
  return inputs;
}

TEST(SceneTasksTest, NumbersInTasksAreTheTasksOwn) {
  const TemporaryFolder folder;
  WriteMade(SmallScene(Cut::kClipped), folder.path());
  const auto inputs = InputsOf(folder.path());
  ASSERT_GT(inputs.at(Stage::kFill).size(), 3U);
  for (const std::string& bytes : inputs.at(Stage::kFill)) {
    v1::FillInput input;
    ASSERT_TRUE(input.ParseFromString(bytes));
    int32_t most = -1;
    for (const v1::HoleBoundary& hole : input.holes().holes()) {
      EXPECT_LE(hole.id(), most + 1);
      most = std::max(most, hole.id());
    }
  }
  for (const std::string& bytes : inputs.at(Stage::kSampleCluster)) {
    v1::SampleClusterInput input;
    ASSERT_TRUE(input.ParseFromString(bytes));
    EXPECT_LT(input.cluster(), 2);
    for (const int32_t vertex : input.holes().vertices().seam_vertex()) {
      EXPECT_LT(vertex, input.holes().vertices().seam_vertex_size());
    }
  }
}

TEST(SceneTasksTest, AClusterThatWasNotAskedForIsNoResult) {
  const TemporaryFolder folder;
  WriteMade(SmallScene(Cut::kClipped), folder.path());
  JobSpec spec = WithDefaults({});
  SceneWaves waves(
      LoadScene(folder.path(), [](const std::string&, const TileFrame&) { return absl::UnimplementedError(""); })
          .value(),
      WaveOptionsOf(spec, {}, [] { return false; }));
  SceneTasks tasks(spec, waves, nullptr, ScratchFile::Create("").value());
  EXPECT_TRUE(absl::IsInternal(tasks.Take({{0, 0}, Stage::kSampleCluster, "", v1::SampleClusterOutput(), {}})));
}

}  // namespace
}  // namespace tilemend
