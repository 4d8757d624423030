// Material files and images that are changed while a job runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <string>

#include "common/rpc/status_proto.h"
#include "common/util/exit_codes.h"
#include "common/util/files.h"
#include "coordinator/jobs/result_checks.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "tests/support/test_cluster.h"
#include "tests/support/textured_scene.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

constexpr char kLibrary[] = "scene/Data/Tile_+001_+000/Tile_+001_+000.mtl";
constexpr char kImage[] = "scene/shared/my ground.jpg";

class CarriedChangeTest : public ::testing::Test {
 protected:
  CarriedChangeTest() : cluster_(Options()) { WriteTexturedScene(folder_); }

  static ClusterOptions Options() {
    ClusterOptions options;
    options.factory = ScenePipelineFactory();
    options.check_result = SceneResultCheck(TileCheck::kContent);
    return options;
  }
  // Changes the file once, before the first task of `stage` or after it.
  StageRunner Changing(Stage stage, const std::string& file, bool before) {
    return [=, this, run = SceneStageRunner()](Stage s, const std::string& input, const CancelToken& cancel) {
      const bool now = s == stage && !changed_.exchange(true);
      if (now && before) Change(file);
      auto output = run(s, input, cancel);
      if (now && !before) Change(file);
      return output;
    };
  }
  void Change(const std::string& file) { folder_.Write(file, ReadFile(folder_ / file).value() + "\n#"); }

  void ExpectNamed(StageRunner runner, const std::string& file) {
    cluster_.AddWorker("worker", 1, std::move(runner));
    const v1::Job job = cluster_.WaitFor(cluster_.Submit(folder_ / "scene").name());
    EXPECT_EQ(job.state(), v1::FAILED);
    EXPECT_EQ(ExitCodeOf(StatusFromProto(job.error())), kExitRetryable);
    EXPECT_THAT(job.error().message(), HasSubstr(folder_ / file + ": changed while the job ran"));
  }

  const TemporaryFolder folder_;
  std::atomic<bool> changed_{false};
  TestCluster cluster_;
};

TEST_F(CarriedChangeTest, AMaterialFileIsNamedBeforeItIsAddedTo) {
  ExpectNamed(Changing(Stage::kFill, kLibrary, true), kLibrary);
}

TEST_F(CarriedChangeTest, AnImageThatGaveAColourIsNamed) { ExpectNamed(Changing(Stage::kFill, kImage, true), kImage); }

// The worker did well, and the coordinator finds another original.
TEST_F(CarriedChangeTest, NoWorkerIsBlamedForWhatBecomesOfAnOriginal) {
  ExpectNamed(Changing(Stage::kAssemble, "scene/Data/Tile_+000_+000/Tile_+000_+000.mtl", false),
              "scene/Data/Tile_+000_+000/Tile_+000_+000.mtl");
}

}  // namespace
}  // namespace tilemend
