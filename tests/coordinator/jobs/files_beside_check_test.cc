#include "coordinator/jobs/files_beside_check.h"

#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <map>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/options/job_options.h"
#include "common/util/files.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textured_scene.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

// Two tiles with an image and a lake over their border.
class FilesBesideCheckTest : public testing::Test {
 protected:
  void SetUp() override { WriteImageScene(folder_); }

  // `see` is called with each assembled tile before its files are placed.
  void Run(const std::string& texture, const std::function<void(const v1::AssembleInput&, v1::AssembleOutput)>& see) {
    JobSpec spec = WithDefaults({});
    spec.set_scene(folder_ / "scene");
    spec.set_out(folder_ / absl::StrCat("out_", ++runs_));
    spec.set_texture(texture);
    auto pipeline = ScenePipelineFactory()(spec, {});
    ASSERT_TRUE(pipeline.ok()) << pipeline.status();
    auto tasks = (*pipeline)->Start();
    ASSERT_TRUE(tasks.ok()) << tasks.status();
    std::deque<NewTask> open(tasks->begin(), tasks->end());
    while (!open.empty()) {
      const NewTask task = open.front();
      open.pop_front();
      auto output = SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken());
      ASSERT_TRUE(output.ok()) << output.status();
      v1::AssembleInput input;
      v1::AssembleOutput result;
      if (task.stage == Stage::kAssemble && input.ParseFromString(task.input) && result.ParseFromString(*output)) {
        see(input, result);
      }
      tasks = (*pipeline)->OnTaskDone({task.cell, task.stage, *std::move(output)});
      ASSERT_TRUE(tasks.ok()) << tasks.status();
      open.insert(open.end(), tasks->begin(), tasks->end());
    }
  }

  static absl::Status Check(const v1::AssembleInput& input, const v1::AssembleOutput& output) {
    return SceneResultCheck(TileCheck::kContent)(Stage::kAssemble, input.SerializeAsString(),
                                                 output.SerializeAsString());
  }

  const TemporaryFolder folder_;
  int runs_ = 0;
};

TEST_F(FilesBesideCheckTest, TakesTilesInEachTexture) {
  std::map<std::string, int> images;
  for (const char* texture : {"synthesize", "flat", "none"}) {
    Run(texture, [&](const v1::AssembleInput& input, const v1::AssembleOutput& output) {
      EXPECT_TRUE(Check(input, output).ok()) << Check(input, output);
      images[texture] += HasTexture(input, output) ? 1 : 0;
    });
  }
  EXPECT_EQ(images["synthesize"], 2);
  EXPECT_EQ(images["flat"], 0);
  EXPECT_EQ(images["none"], 0);
}

TEST_F(FilesBesideCheckTest, TheSameSceneGivesTheSameBytes) {
  std::map<std::string, std::string> first, second;
  for (auto* digests : {&first, &second}) {
    Run("synthesize", [&](const v1::AssembleInput&, const v1::AssembleOutput& output) {
      for (const v1::WrittenFile& file : output.files()) (*digests)[file.path()] = file.digest();
    });
  }
  EXPECT_EQ(first, second);
  EXPECT_TRUE(first.contains("T0_tilemend.jpg"));
}

TEST_F(FilesBesideCheckTest, RefusesAnImageThatIsChangedOrLeftOut) {
  Run("synthesize", [&](const v1::AssembleInput& input, v1::AssembleOutput output) {
    for (int i = 0; i < output.files_size(); ++i) {
      if (output.files(i).path() != input.texture()) continue;
      v1::AssembleOutput without = output;
      without.mutable_files()->DeleteSubrange(i, 1);
      EXPECT_TRUE(absl::IsDataLoss(CheckBeside(input, without, TileCheck::kSize)));
      output.mutable_files(i)->set_digest(output.files(0).digest());
      EXPECT_TRUE(absl::IsDataLoss(CheckBeside(input, output, TileCheck::kContent)));
      output.mutable_files(i)->set_digest("none");
      EXPECT_TRUE(absl::IsDataLoss(CheckBeside(input, output, TileCheck::kSize)));
    }
  });
}

TEST_F(FilesBesideCheckTest, RefusesATileWithOtherCorners) {
  Run("synthesize", [&](const v1::AssembleInput& input, v1::AssembleOutput output) {
    const std::string path = absl::StrCat(input.attempts(), "/", output.files(0).attempt());
    const std::string bytes = ReadFile(path).value();
    std::string changed = bytes;
    changed[changed.rfind("\nv ") + 3] = '7';
    ASSERT_TRUE(WriteFileAtomically(path, changed).ok());
    EXPECT_FALSE(Check(input, output).ok());
    ASSERT_TRUE(WriteFileAtomically(path, bytes).ok());
  });
}

}  // namespace
}  // namespace tilemend
