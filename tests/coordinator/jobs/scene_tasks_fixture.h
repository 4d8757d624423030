// The tasks of a small made scene, run one after the other.
#ifndef TILEMEND_TESTS_COORDINATOR_JOBS_SCENE_TASKS_FIXTURE_H_
#define TILEMEND_TESTS_COORDINATOR_JOBS_SCENE_TASKS_FIXTURE_H_

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/options/job_options.h"
#include "coordinator/jobs/scene_options.h"
#include "coordinator/jobs/scene_tasks.h"
#include "tests/support/output_checks.h"
#include "tests/support/temporary_folder.h"
#include "worker/service/scene_stages.h"

namespace tilemend {

class SceneTasksFixture : public testing::Test {
 protected:
  SceneTasksFixture() {
    WriteMade(SmallScene(Cut::kClipped), folder_ / "scene");
    spec_.set_scene(folder_ / "scene");
    spec_.set_out(folder_ / "out");
  }

  // Before the first task.
  void Begin() {
    Scene scene = LoadScene(spec_.scene(), [](const std::string&, const TileFrame&) {
                    return absl::UnimplementedError("");
                  }).value();
    output_.emplace(OutputFolder::Claim(spec_.out(), scene, false, "key").value());
    ASSERT_TRUE(output_->BeginWriting().ok());
    waves_.emplace(std::move(scene), WaveOptionsOf(spec_, {}, [] { return false; }));
    tasks_.emplace(spec_, *waves_, &*output_, ScratchFile::Create("").value());
  }

  // Runs the scene. Returns the inputs of all tasks by stage, as the tasks were made.
  std::map<Stage, std::vector<std::string>> Run() {
    Begin();
    std::map<Stage, std::vector<std::string>> inputs;
    std::vector<NewTask> open;
    while (true) {
      while (auto work = waves_->Next()) {
        open.push_back(tasks_->TaskOf(*work).value());
        inputs[open.back().stage].push_back(open.back().input);
      }
      if (open.empty()) break;
      const NewTask task = open.back();
      open.pop_back();
      const absl::Status taken = tasks_->Take(
          DecodeResult({task.cell, task.stage, SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken())})
              .value());
      EXPECT_TRUE(taken.ok()) << taken;
    }
    EXPECT_TRUE(waves_->done());
    return inputs;
  }

  template <typename Message>
  static Message Parsed(const std::string& bytes) {
    Message message;
    EXPECT_TRUE(message.ParseFromString(bytes));
    return message;
  }

  const TemporaryFolder folder_;
  JobSpec spec_ = WithDefaults({});
  std::optional<OutputFolder> output_;
  std::optional<SceneWaves> waves_;
  std::optional<SceneTasks> tasks_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COORDINATOR_JOBS_SCENE_TASKS_FIXTURE_H_
