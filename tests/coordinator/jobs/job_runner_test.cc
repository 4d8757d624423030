#include "coordinator/jobs/job_runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <new>
#include <stdexcept>
#include <utility>

#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

// Gives one task, then ends with the bytes that came of it. What goes otherwise, a test says.
class FakePipeline : public JobPipeline {
 public:
  struct Script {
    std::function<void()> on_result, on_finish;
    bool stalls = false;
    bool too_late_to_cancel = false;
    std::string catches = {};  // a worker, if the first result says something else than "true"
  };
  explicit FakePipeline(Script script) : script_(std::move(script)) {}

  absl::StatusOr<std::vector<NewTask>> Start() override {
    return std::vector<NewTask>{{{2, 1}, Stage::kFill, "the input"}};
  }
  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult result) override {
    if (script_.on_result) script_.on_result();
    result_ = std::move(result);
    done_ = !script_.stalls;
    return std::vector<NewTask>();
  }
  std::optional<CaughtWorker> Caught() const override {
    if (script_.catches.empty() || *result_.output == "true") return std::nullopt;
    return CaughtWorker{script_.catches, "it lied"};
  }
  bool Done() const override { return done_; }
  Progress GetProgress() const override { return {"at it", 1, 0, 0, 0}; }
  absl::StatusOr<JobOutcome> Finish() override {
    if (script_.on_finish) script_.on_finish();
    JobOutcome outcome;
    outcome.message = result_.output.ok() ? *result_.output : std::string(result_.output.status().message());
    return outcome;
  }
  bool Cancel() override { return !script_.too_late_to_cancel; }

 private:
  const Script script_;
  TaskResult result_;
  bool done_ = false;
};

class JobRunnerTest : public ::testing::Test {
 protected:
  JobRunnerTest() : blobs_(BlobFolder::Create(folder_ / "blobs").value()) {}

  std::unique_ptr<JobRunner> Run(FakePipeline::Script script = {}) {
    return RunFactory(
        [script](const JobSpec&, const std::stop_token&) { return std::make_unique<FakePipeline>(script); });
  }
  std::unique_ptr<JobRunner> RunFactory(PipelineFactory factory, JobRunner::Mode mode = JobRunner::Mode::kRun) {
    JobRunner::Sink sink;
    sink.recall = [this](std::vector<TaskSpec>& tasks) {
      for (TaskSpec& task : tasks) task.known = known_;
      return TaskContents();
    };
    sink.add_tasks = [this](std::vector<TaskSpec> tasks, const TaskContents&, const Progress& progress) {
      if (tasks.empty()) return absl::OkStatus();
      if (++given_out_ == 1) tasks_.set_value({std::move(tasks), progress});
      if (given_out_ > 1) tasks_again_.set_value();
      return absl::OkStatus();
    };
    sink.caught = [this](const CaughtWorker& worker) {
      caught_ = worker.worker;
      return may_begin_again_ ? absl::OkStatus() : absl::AbortedError(worker.reason);
    };
    sink.begins_again = [this] {
      ++begun_again_;
      return absl::OkStatus();
    };
    sink.await = [] {};
    sink.completed = [](const JobOutcome&, const Progress&) {};
    sink.released = [] {};
    sink.finished = [this](absl::StatusOr<JobOutcome> outcome) { outcome_.set_value(std::move(outcome)); };
    return std::make_unique<JobRunner>(JobSpec(), std::move(factory), blobs_, std::move(sink), mode);
  }
  // The first tasks, once they are added.
  std::pair<std::vector<TaskSpec>, Progress> AwaitTasks() { return tasks_.get_future().get(); }
  absl::StatusOr<JobOutcome> AwaitOutcome() { return outcome_.get_future().get(); }

  static SettledTask Committed(const std::string& output = "") {
    SettledTask task;
    task.cell = {2, 1};
    task.stage = Stage::kFill;
    task.input = Sha256Hex("the input");
    task.output = output;
    return task;
  }

  const TemporaryFolder folder_;
  const std::shared_ptr<BlobFolder> blobs_;
  std::optional<KnownResult> known_;  // what an earlier process knows of every task
  std::promise<std::pair<std::vector<TaskSpec>, Progress>> tasks_;
  std::promise<absl::StatusOr<JobOutcome>> outcome_;
  // Of jobs that begin again.
  int given_out_ = 0, begun_again_ = 0;
  bool may_begin_again_ = true;
  std::string caught_;
  std::promise<void> tasks_again_;
};

TEST_F(JobRunnerTest, StoresInputsAndHandsResultsToThePipeline) {
  const auto runner = Run();
  const auto [tasks, progress] = AwaitTasks();
  ASSERT_EQ(tasks.size(), 1U);
  EXPECT_EQ(tasks[0].cell, (CellId{2, 1}));
  EXPECT_EQ(blobs_->Read(tasks[0].input).value(), "the input");
  EXPECT_EQ(progress.phase, "at it");
  runner->inbox().Deliver(Committed(), "the output");
  EXPECT_EQ(AwaitOutcome()->message, "the output");
}

TEST_F(JobRunnerTest, StoresNoInputOfATaskThatWasSettledBefore) {
  known_ = KnownResult{TaskState::kCommitted, "digest", absl::OkStatus()};
  const auto runner = Run();
  const auto [tasks, progress] = AwaitTasks();
  EXPECT_EQ(tasks[0].input, Sha256Hex("the input"));
  EXPECT_FALSE(blobs_->Size(tasks[0].input).ok());
  SettledTask settled = Committed();
  settled.known = true;
  runner->inbox().Deliver(settled, "the output");
  EXPECT_EQ(AwaitOutcome()->message, "the output");
}

TEST_F(JobRunnerTest, BeginsAgainWithoutTheResultsOfAWorkerThatLied) {
  FakePipeline::Script script;
  script.catches = "liar";
  const auto runner = Run(script);
  const auto [tasks, progress] = AwaitTasks();
  runner->inbox().Deliver(Committed(), "a lie");
  tasks_again_.get_future().get();
  EXPECT_EQ(caught_, "liar");
  EXPECT_EQ(begun_again_, 1);
  EXPECT_EQ(blobs_->Read(tasks[0].input).value(), "the input") << "it is asked again";
  runner->inbox().Deliver(Committed(), "true");
  EXPECT_EQ(AwaitOutcome()->message, "true");
}

TEST_F(JobRunnerTest, FailsIfItMayNotBeginAgain) {
  may_begin_again_ = false;
  FakePipeline::Script script;
  script.catches = "liar";
  const auto runner = Run(script);
  AwaitTasks();
  runner->inbox().Deliver(Committed(), "a lie");
  const auto outcome = AwaitOutcome();
  EXPECT_EQ(outcome.status().message(), "it lied");
  EXPECT_EQ(begun_again_, 0);
}

TEST_F(JobRunnerTest, BeginsAgainWhenItIsToldTo) {
  FakePipeline::Script script;
  const auto runner = Run(script);
  AwaitTasks();
  runner->inbox().Fail(BegunAgain());
  tasks_again_.get_future().get();
  runner->inbox().Deliver(Committed(), "the output");
  EXPECT_EQ(AwaitOutcome()->message, "the output");
  EXPECT_EQ(begun_again_, 1);
}

// Refuses the first so many times, since another process holds the output.
PipelineFactory BusyAtFirst(int times) {
  return [left = std::make_shared<int>(times)](const JobSpec&,
                                               const std::stop_token&) -> absl::StatusOr<std::unique_ptr<JobPipeline>> {
    if (--*left < 0) return std::make_unique<FakePipeline>(FakePipeline::Script());
    return WithErrorInfo(absl::AbortedError("busy"), {"OUTPUT_IN_USE", {}});
  };
}

TEST_F(JobRunnerTest, AJobThatResumesWaitsForItsOutput) {
  const auto runner = RunFactory(BusyAtFirst(2), JobRunner::Mode::kResume);
  AwaitTasks();
  runner->inbox().Deliver(Committed(), "the output");
  EXPECT_EQ(AwaitOutcome()->message, "the output");
}

TEST_F(JobRunnerTest, ANewJobDoesNotWaitForItsOutput) {
  const auto runner = RunFactory(BusyAtFirst(1));
  EXPECT_EQ(ErrorReason(AwaitOutcome().status()), "OUTPUT_IN_USE");
}

TEST_F(JobRunnerTest, ReadsAResultThatIsABlob) {
  const auto runner = Run();
  AwaitTasks();
  runner->inbox().Deliver(Committed(blobs_->Put("a long output").value()), std::nullopt);
  EXPECT_EQ(AwaitOutcome()->message, "a long output");
}

TEST_F(JobRunnerTest, AFailedTaskIsThePipelinesToJudge) {
  const auto runner = Run();
  AwaitTasks();
  SettledTask task = Committed();
  task.state = TaskState::kFailed;
  task.error = absl::InternalError("it broke");
  runner->inbox().Deliver(task, std::nullopt);
  const auto outcome = AwaitOutcome();
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(outcome->message, "it broke");
}

TEST_F(JobRunnerTest, AMissingBlobFailsTheJob) {
  const auto runner = Run();
  AwaitTasks();
  runner->inbox().Deliver(Committed(Sha256Hex("never stored")), std::nullopt);
  EXPECT_TRUE(absl::IsNotFound(AwaitOutcome().status()));
}

TEST_F(JobRunnerTest, CancelEndsAJobThatWaits) {
  const auto runner = Run();
  AwaitTasks();
  EXPECT_TRUE(runner->inbox().Cancel());
  EXPECT_TRUE(absl::IsCancelled(AwaitOutcome().status()));
  EXPECT_TRUE(runner->inbox().Cancel()) << "again";
}

TEST_F(JobRunnerTest, CancelIsRefusedWhenThePipelineSaysThatItIsTooLate) {
  FakePipeline::Script script;
  script.too_late_to_cancel = true;
  const auto runner = Run(script);
  AwaitTasks();
  EXPECT_FALSE(runner->inbox().Cancel());
  runner->inbox().Deliver(Committed(), "kept");
  EXPECT_EQ(AwaitOutcome()->message, "kept");
  EXPECT_FALSE(runner->inbox().Cancel()) << "the job is over";
}

TEST_F(JobRunnerTest, APipelineThatThrowsFailsItsJobAlone) {
  FakePipeline::Script script;
  script.on_result = [] { throw std::runtime_error("out of range"); };
  const auto runner = Run(script);
  AwaitTasks();
  runner->inbox().Deliver(Committed(), "x");
  const absl::Status status = AwaitOutcome().status();
  EXPECT_TRUE(absl::IsInternal(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("out of range"));
}

TEST_F(JobRunnerTest, WantOfMemoryIsToBeTriedAgain) {
  FakePipeline::Script script;
  script.on_finish = [] { throw std::bad_alloc(); };
  const auto runner = Run(script);
  AwaitTasks();
  runner->inbox().Deliver(Committed(), "x");
  EXPECT_TRUE(absl::IsResourceExhausted(AwaitOutcome().status()));
}

TEST_F(JobRunnerTest, APipelineWithoutTasksThatIsNotDoneFails) {
  FakePipeline::Script script;
  script.stalls = true;
  const auto runner = Run(script);
  AwaitTasks();
  runner->inbox().Deliver(Committed(), "x");
  EXPECT_TRUE(absl::IsInternal(AwaitOutcome().status()));
}

TEST_F(JobRunnerTest, AnErrorOfTheFactoryIsThatOfTheJob) {
  const auto runner =
      RunFactory([](const JobSpec&, const std::stop_token&) { return absl::NotFoundError("no such scene"); });
  EXPECT_EQ(AwaitOutcome().status(), absl::NotFoundError("no such scene"));
}

TEST_F(JobRunnerTest, TheEndTakesTheBlobsAway) {
  {
    const auto runner = Run();
    AwaitTasks();
    runner->inbox().Deliver(Committed(), "x");
    EXPECT_TRUE(AwaitOutcome().ok());
    EXPECT_FALSE(runner->may_write());
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "blobs"));
}

}  // namespace
}  // namespace tilemend
