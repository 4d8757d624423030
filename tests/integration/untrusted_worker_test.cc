// Workers that are late or cut off: a job never ends as done with a wrong or missing tile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "absl/strings/str_replace.h"
#include "common/rpc/status_proto.h"
#include "common/util/error_info.h"
#include "common/util/exit_codes.h"
#include "common/util/files.h"
#include "tests/support/untrusted_workers.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/service/look_at_folders.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

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
  ASSERT_TRUE(cluster_.coordinator().calls().jobs.CancelJob(cancel).ok());
  cluster_.AddWorker("good", 2, SceneStageRunner());
  v1::RetryJobRequest retry;
  retry.set_name(first.name());
  retry.set_overwrite(true);
  absl::StatusOr<v1::Job> second = cluster_.coordinator().calls().jobs.RetryJob(retry);
  while (absl::IsAborted(second.status()))
    second = cluster_.coordinator().calls().jobs.RetryJob(retry);  // the first is just ending
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
  cluster_.KillWorker("worker");  // it may still be at a tile
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
  cluster_.KillWorker("worker");  // it may still be at a tile
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_EQ(ExitCodeOf(StatusFromProto(job.error())), kExitRetryable);
  EXPECT_THAT(job.error().message(), HasSubstr("not there as it was written"));
  EXPECT_FALSE(std::filesystem::exists(out + "/report.json"));
}

// Sees one folder under the name of another, as over a mount that is not that of the others.
struct OtherMount {
  std::string path, there;
  std::string Map(const std::string& text) const { return absl::StrReplaceAll(text, {{path, there}}); }

  StageRunner Runner() const {
    return [*this, run = SceneStageRunner()](Stage stage, const std::string& bytes, const CancelToken& cancel) {
      v1::AssembleInput input;
      if (stage != Stage::kAssemble || !input.ParseFromString(bytes)) return run(stage, bytes, cancel);
      input.set_attempts(Map(input.attempts()));
      return run(stage, input.SerializeAsString(), cancel);
    };
  }
  v1::FoldersSeen Look(const v1::JobFolders& folders) const {
    v1::JobFolders mapped = folders;
    for (std::string& file : *mapped.mutable_files()) file = Map(file);
    mapped.set_attempts(Map(folders.attempts()));
    return LookAtFolders(mapped);
  }
};

class OtherMountTest : public UntrustedWorkerTest {
 protected:
  void AddStranger(const OtherMount& mount) {
    WorkerOptions options;
    options.id = "stranger";
    options.look = [mount](const v1::JobFolders& folders) { return mount.Look(folders); };
    cluster_.AddWorker(options, mount.Runner());
  }
  // With a good worker that comes when the stranger has been told of.
  v1::Job RunWithBoth() {
    const std::string name = cluster_.Submit(scene_).name();
    while (cluster_.Get(name).warnings().empty()) std::this_thread::yield();
    EXPECT_EQ(cluster_.Metric("tilemend_coordinator_workers_blind"), 1);
    EXPECT_EQ(cluster_.Get(name).progress().tasks_running(), 0) << "it gets no task";
    cluster_.AddWorker("good", 2, SceneStageRunner());
    return cluster_.WaitFor(name);
  }
};

TEST_F(OtherMountTest, AWorkerWithAnotherOutputFolderGetsNoTask) {
  const std::string there = cluster_.folder() / "elsewhere";
  std::filesystem::create_directories(there + "/.tilemend-attempts");
  ASSERT_TRUE(WriteFileAtomically(there + "/.tilemend-attempts/key", std::string(32, '0')).ok());
  AddStranger({cluster_.folder() / "out-1", there});
  const v1::Job job = RunWithBoth();
  EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
  EXPECT_EQ(TilesBelow(Out(job)).size(), 12U);
  ASSERT_EQ(job.warnings_size(), 1);
  EXPECT_THAT(job.warnings(0), HasSubstr("worker stranger gets no task"));
  EXPECT_THAT(job.warnings(0), HasSubstr("another file there"));
  EXPECT_FALSE(std::filesystem::exists(there + "/tiles"));
}

TEST_F(OtherMountTest, AWorkerWithoutTheSceneGetsNoTask) {
  AddStranger({scene_, cluster_.folder() / "elsewhere"});
  const v1::Job job = RunWithBoth();
  EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
  ASSERT_EQ(job.warnings_size(), 1);
  EXPECT_THAT(job.warnings(0), HasSubstr("elsewhere"));
}

TEST_F(OtherMountTest, AWorkerThatLosesTheOutputWhileItWorksIsReplaced) {
  OtherMount lost{cluster_.folder() / "out-1", cluster_.folder() / "elsewhere"};
  WorkerOptions options;
  options.id = "stranger";
  std::atomic<int> looks{0};
  options.look = [&](const v1::JobFolders& folders) {
    return ++looks == 1 ? LookAtFolders(folders) : lost.Look(folders);
  };
  cluster_.AddWorker(options, lost.Runner());
  const v1::Job job = RunWithBoth();
  EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
  EXPECT_EQ(TilesBelow(Out(job)).size(), 12U);
}

TEST_F(UntrustedWorkerTest, PathsMustBeAbsoluteAndTheSceneThere) {
  v1::CreateJobRequest request;
  const auto refused = [&](const std::string& scene, const std::string& out) {
    request.mutable_spec()->set_scene(scene);
    request.mutable_spec()->set_out(out);
    return cluster_.coordinator().calls().jobs.CreateJob(request).status();
  };
  EXPECT_EQ(ErrorReason(refused("scene", "/tmp/out")), "INVALID_SPEC");
  EXPECT_EQ(ErrorReason(refused(scene_, "out")), "INVALID_SPEC");
  const absl::Status gone = refused(cluster_.folder() / "none", "/tmp/out");
  EXPECT_EQ(ErrorReason(gone), "SCENE_NOT_FOUND");
  EXPECT_EQ(ExitCodeOf(gone), kExitNotFound);
}

}  // namespace
}  // namespace tilemend
