// Results that workers report.
#include "coordinator/api/result_intake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/util/files.h"
#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

using ResultIntakeTest = CoordinatorTest;

TEST_F(ResultIntakeTest, RefusesLateResultsAndCountsThem) {
  const auto job = calls_.jobs.CreateJob(NewRequest());
  const v1::Task late = AwaitTask("slow");
  cluster_.ExpireLeases();
  const v1::Task task = AwaitTask("fast");
  EXPECT_EQ(task.ref().task(), late.ref().task());
  EXPECT_EQ(task.attempt(), 2);
  for (const v1::Task* reported : {&late, &task, &task}) {
    v1::SyncRequest report = NewSync(reported == &late ? "slow" : "fast", 0);
    auto* finished = report.add_finished();
    *finished->mutable_ref() = reported->ref();
    finished->set_stage(reported->stage());
    finished->mutable_output()->set_content("5 ");
    finished->mutable_output()->set_size(2);
    EXPECT_EQ(Sync(report).acknowledged_size(), 1);
  }
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_tasks_refused_late_total{stage=\"survey\"}"), 1);
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_tasks_finished_total{stage=\"survey\"}"), 1);
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_tasks_retried_total{stage=\"survey\"}"), 1);
  EXPECT_EQ(cluster_.Get(job->name()).progress().tasks_done(), 1);
}

TEST_F(ResultIntakeTest, RetriesAResultWhoseBlobNeverCame) {
  const auto job = calls_.jobs.CreateJob(NewRequest());
  const v1::Task task = AwaitTask();
  v1::SyncRequest report = NewSync("w", 0);
  auto* finished = report.add_finished();
  *finished->mutable_ref() = task.ref();
  finished->set_stage(task.stage());
  finished->mutable_output()->set_digest(std::string(64, 'a'));
  finished->mutable_output()->set_size(1'000'000);
  EXPECT_EQ(Sync(report).acknowledged_size(), 1);
  EXPECT_EQ(cluster_.Get(job->name()).progress().tasks_done(), 0);
  EXPECT_EQ(AwaitTask().ref().task(), 2) << "the first is to wait a little";
  cluster_.clock().Advance(absl::Seconds(1));
  EXPECT_EQ(AwaitTask("other").attempt(), 2);
}

TEST_F(ResultIntakeTest, TakesAResultFromItsHolderAlone) {
  const auto job = calls_.jobs.CreateJob(NewRequest());
  const v1::Task task = AwaitTask("holder");
  v1::SyncRequest stranger = NewSync("stranger", 0);
  Finish(task, stranger);
  *stranger.add_held() = task.ref();
  EXPECT_EQ(Sync(stranger).keep_size(), 0);
  EXPECT_EQ(cluster_.Get(job->name()).progress().tasks_done(), 0);
  EXPECT_EQ(cluster_.Metric("tilemend_coordinator_tasks_refused_late_total{stage=\"survey\"}"), 1);
  v1::SyncRequest holder = NewSync("holder", 0);
  Finish(task, holder);
  Sync(holder);
  EXPECT_EQ(cluster_.Get(job->name()).progress().tasks_done(), 1);
}

TEST_F(ResultIntakeTest, AFileThatOneMachineDoesNotSeeIsTriedOnAnother) {
  const auto job = calls_.jobs.CreateJob(NewRequest());
  const v1::Task task = AwaitTask("blind");
  v1::SyncRequest other = NewSync("other");
  other.set_wait_ms(0);
  Sync(other);  // takes the second task
  v1::SyncRequest report = NewSync("blind", 1);
  auto* finished = report.add_finished();
  *finished->mutable_ref() = task.ref();
  finished->set_stage(task.stage());
  finished->mutable_error()->set_code(static_cast<int>(absl::StatusCode::kNotFound));
  EXPECT_EQ(Sync(report).start_size(), 0) << "not to the same again";
  EXPECT_EQ(cluster_.Get(job->name()).progress().tasks_done(), 0);
  EXPECT_EQ(cluster_.Get(job->name()).progress().tasks_retried(), 1);
}

TEST_F(ResultIntakeTest, KeepsNoEndlessTextOfAWorker) {
  const auto job = calls_.jobs.CreateJob(NewRequest());
  const v1::Task task = AwaitTask();
  v1::SyncRequest report = NewSync("w", 0);
  auto* finished = report.add_finished();
  *finished->mutable_ref() = task.ref();
  finished->set_stage(task.stage());
  finished->mutable_output()->set_digest(std::string(1 << 20, 'x'));
  finished->mutable_output()->set_size(1);
  Sync(report);
  const v1::Job told = cluster_.Get(job->name());
  ASSERT_EQ(told.warnings_size(), 1) << "no digest: the result is refused";
  EXPECT_LT(told.ByteSizeLong(), 10'000U);
}

struct HasAttempts {
  TempFolder attempts_;
};

// Of workers that write a file for each result.
class WrittenResultTest : private HasAttempts, public CoordinatorTest {
 protected:
  static constexpr char kFile[] = "0123456789abcdef0123456789abcdef-0";

  WrittenResultTest() : CoordinatorTest(Writing(attempts_.path().string())) {
    EXPECT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  }
  static ClusterOptions Writing(const std::string& attempts) {
    ClusterOptions options = Options();
    options.durable = true;
    options.factory = ToysWithFolders({{}, attempts});
    options.attempts_of = [](Stage, const std::string&) { return std::vector<std::string>{kFile}; };
    return options;
  }

  // As AwaitTask, for a worker that has yet to look at the folder.
  v1::Task Take(const std::string& worker) {
    v1::SyncResponse told;
    for (int tries = 0; tries < 20 && told.start_size() == 0; ++tries) {
      v1::SyncRequest request = NewSync(worker);
      for (const v1::JobFolders& look : told.look()) request.add_seen()->set_job(look.job());
      told = Sync(request);
    }
    EXPECT_EQ(told.start_size(), 1);
    return told.start_size() == 0 ? v1::Task() : told.start(0);
  }
  // Whether the file is there when the result has been reported.
  bool FileStays(const std::string& worker, const v1::Task& task) {
    EXPECT_TRUE(WriteFileAtomically(attempts_ / kFile, "tile").ok());
    v1::SyncRequest report = NewSync(worker, 0);
    Finish(task, report);
    EXPECT_EQ(Sync(report).acknowledged_size(), 1);
    return ReadFile(attempts_ / kFile).ok();
  }
};

TEST_F(WrittenResultTest, TheFilesOfALateOneGo) {
  const v1::Task late = Take("slow");
  cluster_.ExpireLeases();
  const v1::Task task = Take("fast");
  EXPECT_FALSE(FileStays("slow", late));
  EXPECT_TRUE(FileStays("fast", task));
  EXPECT_TRUE(FileStays("fast", task)) << "the same once more";
}

// The journal has it, but not who gave it.
TEST_F(WrittenResultTest, TheFilesOfOneThatAnEarlierCoordinatorAcceptedStay) {
  const v1::Task task = Take("worker");
  EXPECT_TRUE(FileStays("worker", task));
  cluster_.Restart();
  Take("other");  // the job goes on
  EXPECT_TRUE(FileStays("worker", task));
}

}  // namespace
}  // namespace tilemend
