// Real scenes in a cluster inside the test, with workers that fail on purpose.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

#include "common/rpc/status_proto.h"
#include "common/util/error_info.h"
#include "common/util/exit_codes.h"
#include "common/util/files.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "tests/support/output_checks.h"
#include "tests/support/test_cluster.h"
#include "tilemend/v1/stages.pb.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class SceneFailureTest : public ::testing::Test {
 protected:
  SceneFailureTest() : cluster_(Options()) { WriteMade(SmallScene(Cut::kClipped), scene_); }

  static ClusterOptions Options() {
    ClusterOptions options;
    options.factory = ScenePipelineFactory();
    return options;
  }
  v1::Job RunWith(StageRunner runner) {
    cluster_.AddWorker("worker", 2, std::move(runner));
    return cluster_.WaitFor(cluster_.Submit(scene_).name());
  }
  std::string Out(const v1::Job& job) { return job.spec().out(); }

  TestCluster cluster_;
  const std::string scene_ = cluster_.folder() / "scene";
};

// Runs the stages, but those of cell (1, 0) that `stage` names give `error`.
StageRunner FailingAt(Stage failing, const absl::Status& error) {
  return [failing, error, run = SceneStageRunner()](Stage stage, const std::string& input, const CancelToken& cancel) {
    CellId cell{-1, -1};
    if (stage == Stage::kFill && failing == stage) {
      v1::FillInput parsed;
      if (parsed.ParseFromString(input)) cell = {parsed.holes().col(), parsed.holes().row()};
    } else if (stage == Stage::kSampleCluster && failing == stage) {
      v1::SampleClusterInput parsed;
      if (parsed.ParseFromString(input)) cell = {parsed.holes().col(), parsed.holes().row()};
    } else if (stage == Stage::kAssemble && failing == stage) {
      v1::AssembleInput parsed;
      if (parsed.ParseFromString(input)) cell = {parsed.tile().col(), parsed.tile().row()};
    }
    return cell == CellId{1, 0} ? absl::StatusOr<std::string>(error) : run(stage, input, cancel);
  };
}

class BrokenCellTest : public SceneFailureTest, public ::testing::WithParamInterface<Stage> {};

TEST_P(BrokenCellTest, IsLeftWithItsReasonAndTheRestIsFilled) {
  const v1::Job job = RunWith(FailingAt(GetParam(), absl::InternalError("the solver broke")));
  EXPECT_EQ(job.state(), v1::PARTIAL) << job.error().message();
  const nlohmann::json report = ReportOf(Out(job));
  ASSERT_GT(report["left"].size(), 0U);
  for (const auto& left : report["left"]) {
    EXPECT_EQ(left["cell"], nlohmann::json({1, 0}));
    EXPECT_THAT(left["reason"].get<std::string>(), HasSubstr("the solver broke"));
  }
  int filled = 0;
  for (const auto& hole : report["per_hole"]) filled += hole["outcome"] == "filled" ? 1 : 0;
  EXPECT_EQ(filled + report["left"].size(), report["per_hole"].size());
  EXPECT_GT(filled, 3);
  const std::string tile = "tiles/Tile_+001_+000.ply";
  EXPECT_EQ(TilesBelow(Out(job))[tile], TilesBelow(scene_)[tile]);
  EXPECT_EQ(TilesBelow(Out(job)).size(), 12U);
}

INSTANTIATE_TEST_SUITE_P(Stages, BrokenCellTest, ::testing::Values(Stage::kSampleCluster, Stage::kFill),
                         [](const auto& stage) { return stage.param == Stage::kFill ? "Fill" : "SampleCluster"; });

TEST_F(SceneFailureTest, ADiskThatIsFullEndsTheJobAsRetryable) {
  const v1::Job job = RunWith(FailingAt(Stage::kAssemble, absl::ResourceExhaustedError("No space left on device")));
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_EQ(ExitCodeOf(StatusFromProto(job.error())), kExitRetryable);
  EXPECT_THAT(job.error().message(), HasSubstr("No space left on device"));
  EXPECT_TRUE(std::filesystem::exists(Out(job) + "/.tilemend-job"));
  EXPECT_FALSE(std::filesystem::exists(Out(job) + "/report.json"));
}

// The same job, started again, goes on in the folder of the one that failed.
TEST_F(SceneFailureTest, ARetriedJobCompletesTheOutput) {
  const v1::Job failed = RunWith(FailingAt(Stage::kAssemble, absl::PermissionDeniedError("read-only")));
  EXPECT_EQ(failed.state(), v1::FAILED);
  cluster_.KillWorker("worker");
  cluster_.AddWorker("other", 2, SceneStageRunner());
  v1::RetryJobRequest request;
  request.set_name(failed.name());
  const absl::StatusOr<v1::Job> retried = cluster_.coordinator().calls().jobs.RetryJob(request);  // at once
  ASSERT_TRUE(retried.ok()) << retried.status();
  const v1::Job job = cluster_.WaitFor(retried->name());
  EXPECT_EQ(job.state(), v1::DONE) << job.error().message();
  EXPECT_FALSE(std::filesystem::exists(Out(job) + "/.tilemend-job"));
  ExpectOriginalsKept(scene_, Out(job));
  ExpectClosed(SmallScene(Cut::kClipped), Out(job));
}

TEST_F(SceneFailureTest, ATileThatChangesWhileTheJobRunsEndsIt) {
  std::atomic<bool> changed{false};
  const std::string tile = scene_ + "/tiles/Tile_+003_+002.ply";
  const v1::Job job =
      RunWith([&, run = SceneStageRunner()](Stage stage, const std::string& input, const CancelToken& cancel) {
        if (stage == Stage::kFill && !changed.exchange(true)) {
          EXPECT_TRUE(WriteFileAtomically(tile, ReadFile(tile).value_or("") + " ").ok());
        }
        return run(stage, input, cancel);
      });
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_EQ(ExitCodeOf(StatusFromProto(job.error())), kExitRetryable);
  EXPECT_THAT(job.error().message(), HasSubstr(tile + ": changed while the job ran"));
}

// What a worker of another build might send.
TEST_F(SceneFailureTest, ResultsThatNameNoHoleFailTheJobOnly) {
  const v1::Job job =
      RunWith([run = SceneStageRunner()](Stage stage, const std::string& input, const CancelToken& cancel) {
        auto result = run(stage, input, cancel);
        if (stage != Stage::kFill || !result.ok()) return result;
        v1::FillOutput output;
        EXPECT_TRUE(output.ParseFromString(*result));
        output.mutable_patches(0)->set_hole(1 << 30);
        return absl::StatusOr<std::string>(output.SerializeAsString());
      });
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_THAT(job.error().message(), HasSubstr("cannot be read"));
}

// The pipeline of a scene, but for a call before and one after its Finish.
class FinishWatcher : public JobPipeline {
 public:
  FinishWatcher(std::unique_ptr<JobPipeline> pipeline, std::function<void()> before, std::function<void()> after)
      : pipeline_(std::move(pipeline)), before_(std::move(before)), after_(std::move(after)) {}
  absl::StatusOr<std::vector<NewTask>> Start() override { return pipeline_->Start(); }
  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult result) override {
    return pipeline_->OnTaskDone(std::move(result));
  }
  bool Done() const override { return pipeline_->Done(); }
  Progress GetProgress() const override { return pipeline_->GetProgress(); }
  void Release() override { pipeline_->Release(); }
  bool Cancel() override { return pipeline_->Cancel(); }
  absl::StatusOr<JobOutcome> Finish() override {
    before_();
    auto outcome = pipeline_->Finish();
    after_();
    return outcome;
  }

 private:
  const std::unique_ptr<JobPipeline> pipeline_;
  const std::function<void()> before_, after_;
};

ClusterOptions WatchingFinish(const std::function<void()>& before, const std::function<void()>& after) {
  ClusterOptions options;
  options.factory = [=, scenes = ScenePipelineFactory()](const JobSpec& spec, const std::stop_token& stop) {
    auto pipeline = scenes(spec, stop);
    if (!pipeline.ok()) return pipeline;
    return absl::StatusOr<std::unique_ptr<JobPipeline>>(
        std::make_unique<FinishWatcher>(*std::move(pipeline), before, after));
  };
  return options;
}

// A job is cancelled, or its output is complete: never both, never neither.
TEST(SceneCancelTest, AtTheVeryEndItIsCancelledOrComplete) {
  for (const bool before : {true, false}) {
    absl::StatusOr<v1::Job> cancelled = absl::UnknownError("not tried");
    std::atomic<bool> finished{false};
    TestCluster* all = nullptr;
    const auto cancel = [&] {
      v1::CancelJobRequest request;
      request.set_name(all->coordinator().calls().jobs.ListJobs({})->jobs(0).name());
      cancelled = all->coordinator().calls().jobs.CancelJob(request);
    };
    const auto at_start = [&] {
      if (before) cancel();
    };
    const auto at_end = [&] {
      if (!before) cancel();
      finished = true;
      finished.notify_all();
    };
    TestCluster cluster(WatchingFinish(at_start, at_end));
    all = &cluster;
    const std::string scene = cluster.folder() / "scene";
    WriteMade(SmallScene(Cut::kClipped), scene);
    cluster.AddWorker("worker", 2, SceneStageRunner());
    const std::string name = cluster.Submit(scene).name();
    const v1::Job job = cluster.WaitFor(name);
    finished.wait(false);  // a cancelled job is over before
    EXPECT_EQ(cancelled.ok(), before) << cancelled.status();
    EXPECT_EQ(job.state(), before ? v1::CANCELLED : v1::DONE);
    EXPECT_EQ(ErrorReason(cancelled.status()), before ? "" : "JOB_OVER");
    const std::string out = job.spec().out();
    EXPECT_EQ(std::filesystem::exists(out + "/.tilemend-job"), before);
    EXPECT_EQ(std::filesystem::exists(out + "/report.json"), !before);
  }
}

}  // namespace
}  // namespace tilemend
