// Results that workers report.
#include "coordinator/api/result_intake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

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

}  // namespace
}  // namespace tilemend
