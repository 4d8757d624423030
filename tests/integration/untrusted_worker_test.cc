// What workers do that are late, cut off, broken or lie: a job never ends as done with a wrong or missing tile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <string>
#include <thread>

#include "common/rpc/status_proto.h"
#include "common/util/error_info.h"
#include "common/util/exit_codes.h"
#include "common/util/files.h"
#include "coordinator/service/scene_pipeline.h"
#include "tests/support/output_checks.h"
#include "tests/support/test_cluster.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class UntrustedWorkerTest : public ::testing::Test {
 protected:
  UntrustedWorkerTest() : cluster_(Options()) { WriteMade(SmallScene(Cut::kClipped), scene_); }

  static ClusterOptions Options() {
    ClusterOptions options;
    options.factory = ScenePipelineFactory();
    return options;
  }
  static std::string Out(const v1::Job& job) { return job.spec().out(); }
  // The tiles of an undisturbed job.
  std::map<std::string, std::string> Undisturbed() {
    cluster_.AddWorker("undisturbed", 2, SceneStageRunner());
    const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
    EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
    cluster_.KillWorker("undisturbed");
    return TilesBelow(Out(job));
  }

  TestCluster cluster_;
  const std::string scene_ = cluster_.folder() / "scene";
};

// Also while others write there.
void Remove(const std::string& folder) {
  std::error_code error;
  while (std::filesystem::exists(folder, error)) std::filesystem::remove_all(folder, error);
}

// A worker that stops before its first tile and never hears that the task is not its own any more.
class FrozenWorker {
 public:
  StageRunner Runner() {
    return [this, run = SceneStageRunner()](Stage stage, const std::string& input, const CancelToken&) {
      if (stage != Stage::kAssemble || frozen_.exchange(true)) return run(stage, input, CancelToken());
      frozen_.notify_all();
      woken_.wait(false);
      auto result = run(stage, input, CancelToken());
      wrote_ = result.ok();
      ended_ = true;
      ended_.notify_all();
      return result;
    };
  }
  void AwaitFrozen() { frozen_.wait(false); }
  // Whether it could write.
  bool Wake() {
    woken_ = true;
    woken_.notify_all();
    ended_.wait(false);
    return wrote_;
  }

 private:
  std::atomic<bool> frozen_{false}, woken_{false}, ended_{false}, wrote_{false};
};

TEST_F(UntrustedWorkerTest, ALateAttemptChangesNothingOfTheOutputOfAnotherJob) {
  FrozenWorker frozen;
  cluster_.AddWorker("frozen", 1, frozen.Runner());
  const v1::Job first = cluster_.Submit(scene_);
  frozen.AwaitFrozen();
  v1::CancelJobRequest cancel;
  cancel.set_name(first.name());
  ASSERT_TRUE(cluster_.impl().CancelJob(cancel).ok());
  cluster_.AddWorker("good", 2, SceneStageRunner());
  v1::RetryJobRequest retry;
  retry.set_name(first.name());
  retry.set_overwrite(true);
  absl::StatusOr<v1::Job> second = cluster_.impl().RetryJob(retry);
  while (absl::IsAborted(second.status())) second = cluster_.impl().RetryJob(retry);  // the first is just ending
  ASSERT_TRUE(second.ok()) << second.status();
  const v1::Job job = cluster_.WaitFor(second->name());
  ASSERT_EQ(job.state(), v1::DONE) << job.error().message();
  const auto tiles = TilesBelow(Out(job));
  EXPECT_FALSE(frozen.Wake());
  EXPECT_EQ(TilesBelow(Out(job)), tiles);
  EXPECT_FALSE(std::filesystem::exists(Out(job) + "/.tilemend-attempts"));
}

TEST_F(UntrustedWorkerTest, AnOutputFolderThatIsDeletedWhileTilesAreWrittenEndsTheJobAsRetryable) {
  const std::string out = cluster_.folder() / "out-1";
  std::atomic<int> tiles{0};
  cluster_.AddWorker("worker", 2,
                     [&, run = SceneStageRunner()](Stage stage, const std::string& input, const auto& cancel) {
                       if (stage == Stage::kAssemble && ++tiles == 7) Remove(out);
                       return run(stage, input, cancel);
                     });
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_EQ(ExitCodeOf(StatusFromProto(job.error())), kExitRetryable) << job.error().message();
  EXPECT_FALSE(std::filesystem::exists(out + "/report.json"));
}

TEST_F(UntrustedWorkerTest, TilesThatAreDeletedBeforeTheEndAreMissed) {
  const std::string out = cluster_.folder() / "out-1";
  std::atomic<int> tiles{0};
  cluster_.AddWorker("worker", 1,
                     [&, run = SceneStageRunner()](Stage stage, const std::string& input, const auto& cancel) {
                       if (stage == Stage::kAssemble && ++tiles == 7) {
                         while (!std::filesystem::exists(out + "/tiles")) std::this_thread::yield();
                         Remove(out + "/tiles");
                       }
                       return run(stage, input, cancel);
                     });
  const v1::Job job = cluster_.WaitFor(cluster_.Submit(scene_).name());
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_EQ(ExitCodeOf(StatusFromProto(job.error())), kExitRetryable);
  EXPECT_THAT(job.error().message(), HasSubstr("not there as it was written"));
  EXPECT_FALSE(std::filesystem::exists(out + "/report.json"));
}

}  // namespace
}  // namespace tilemend
