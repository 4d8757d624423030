// A coordinator that ends and starts again from its journal.
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/rpc/limits.h"
#include "coordinator/journal/sqlite_journal.h"
#include "coordinator/journal/sqlite_journal_file.h"
#include "tests/coordinator/jobs/restart_fixture.h"
#include "tests/support/test_cluster.h"
#include "tests/support/waiting_sync.h"

namespace tilemend {
namespace {

// 5 x 4 cells are 60 tasks. Outputs of 100 kB are blobs, those of 1 kB are in the journal.
class RestoreTest : public ::testing::TestWithParam<int> {
 protected:
  const std::string scene_ = absl::StrCat("toy://5x4?bytes=", GetParam());
};

TEST_P(RestoreTest, AJobGoesOnFromEveryTask) {
  const v1::Job undisturbed = Undisturbed(scene_);
  for (int done = 0; done < 60; done += 7) {
    SCOPED_TRACE(absl::StrCat(done, " tasks before the end of the first coordinator"));
    TestCluster cluster(Durable());
    Budget budget(done);
    cluster.AddWorker("first", 2, budget.Runner());
    const std::string name = cluster.Submit(scene_).name();
    budget.AwaitEnd();
    cluster.Restart();
    std::atomic<int> again{0};
    cluster.AddWorker("second", 2, Counting(again));
    const v1::Job job = cluster.WaitFor(name);
    EXPECT_EQ(job.state(), v1::DONE);
    EXPECT_EQ(job.message(), undisturbed.message());
    EXPECT_EQ(job.progress().tasks(), undisturbed.progress().tasks());
    EXPECT_EQ(job.progress().tasks_done(), undisturbed.progress().tasks_done());
    EXPECT_EQ(job.progress().phase(), undisturbed.progress().phase());
    EXPECT_LE(done + again, 60 + 2) << "more than those in flight were done again";
  }
}

TEST_P(RestoreTest, AnotherBuildMakesAllOfItAgain) {
  TestCluster cluster(Durable());
  cluster.UseBuild("other");
  Budget budget(30);
  std::atomic<int> again{0};
  const std::string name = cluster.Submit(scene_).name();
  cluster.Restart();
  cluster.AddWorker("first", 2, budget.Runner());
  budget.AwaitEnd();
  cluster.UseBuild("new");
  cluster.Restart();
  cluster.AddWorker("second", 1, Counting(again));
  const v1::Job job = cluster.WaitFor(name);
  EXPECT_EQ(job.message(), Undisturbed(scene_).message());
  EXPECT_EQ(job.progress().tasks_done(), 60);
  EXPECT_EQ(again, 60) << "results of two builds in one output";
}

TEST_P(RestoreTest, OneBuildGoesOnWhateverAnotherDidBetween) {
  TestCluster cluster(Durable());
  const std::string name = cluster.Submit(scene_).name();
  std::atomic<int> last{0};
  for (const char* build : {"a", "b", "a"}) {
    cluster.UseBuild(build);
    cluster.Restart();
    Budget budget(15);
    cluster.AddWorker("w", 1, budget.Runner());
    budget.AwaitEnd();
  }
  cluster.Restart();
  cluster.AddWorker("last", 1, Counting(last));
  EXPECT_EQ(cluster.WaitFor(name).message(), Undisturbed(scene_).message());
  EXPECT_GE(last, 30);
  EXPECT_LE(last, 60 - 30 + 2);
}

TEST_P(RestoreTest, AJobOutlivesManyCoordinators) {
  TestCluster cluster(Durable());
  const std::string name = cluster.Submit(scene_).name();
  for (int i = 0; i < 12; ++i) {
    Budget budget(4);
    cluster.AddWorker("short", 1, budget.Runner());
    budget.AwaitEnd();
    cluster.Restart();
  }
  std::atomic<int> left{0};
  cluster.AddWorker("last", 1, Counting(left));
  EXPECT_EQ(cluster.WaitFor(name).message(), Undisturbed(scene_).message());
  EXPECT_LE(left, 60 - 12 * 3);
}

INSTANTIATE_TEST_SUITE_P(Bytes, RestoreTest, ::testing::Values(0, 1000, 100'000, 600'000));

TEST(RestoreJobsTest, WhatIsOverStaysAsItWas) {
  TestCluster cluster(Durable());
  cluster.AddWorker("w", 2);
  std::vector<v1::Job> before;
  for (const char* scene : {"toy://3x3", "toy://2x2?plan_error=1", "toy://2x2?fail=1,1", "toy://none"})
    before.push_back(cluster.WaitFor(cluster.Submit(scene).name()));
  cluster.KillWorker("w");
  v1::CancelJobRequest cancel;
  cancel.set_name(cluster.Submit("toy://4x4").name());
  before.push_back(*cluster.coordinator().calls().jobs.CancelJob(cancel));
  cluster.Restart();
  cluster.Restart();
  for (v1::Job& job : before) {
    v1::Job after = cluster.Get(job.name());
    EXPECT_GT(after.cursor(), job.cursor()) << "who watches hears of it again";
    job.clear_cursor();
    after.clear_cursor();
    // A task that was in flight is not told of.
    job.mutable_progress()->clear_tasks_running();
    EXPECT_EQ(after.DebugString(), job.DebugString());
  }
  EXPECT_EQ(cluster.coordinator().calls().jobs.ListJobs({})->jobs_size(), 5);
}

TEST(RestoreJobsTest, ARequestIdGivesTheSameJob) {
  TestCluster cluster(Durable());
  v1::CreateJobRequest request;
  request.mutable_spec()->set_scene("toy://2x2");
  request.mutable_spec()->set_out(cluster.folder() / "o");
  request.set_request_id("mine");
  const std::string name = cluster.coordinator().calls().jobs.CreateJob(request)->name();
  cluster.Restart();
  EXPECT_EQ(cluster.coordinator().calls().jobs.CreateJob(request)->name(), name);
  request.set_request_id("another");
  EXPECT_TRUE(absl::IsAborted(cluster.coordinator().calls().jobs.CreateJob(request).status()))
      << "the folder is in use";
  cluster.AddWorker("w");
  EXPECT_EQ(cluster.WaitFor(name).state(), v1::DONE);
}

TEST(RestoreJobsTest, BlobsThatNoJobNeedsGo) {
  TestCluster cluster(Durable());
  Budget budget(3);
  cluster.AddWorker("w", 1, budget.Runner());
  const std::string name = cluster.Submit("toy://3x3?bytes=100000").name();
  budget.AwaitEnd();
  const std::string folder = cluster.folder() / "work/" + name;
  std::filesystem::create_directories(cluster.folder() / "work/jobs/older");
  std::ofstream(cluster.folder() / "work/jobs/older/blob") << "left";
  std::ofstream(folder + "/part-99") << "left";
  v1::CancelJobRequest cancel;
  cancel.set_name(name);
  cluster.Restart();
  EXPECT_FALSE(std::filesystem::exists(cluster.folder() / "work/jobs/older"));
  EXPECT_FALSE(std::filesystem::exists(folder + "/part-99"));
  ASSERT_TRUE(cluster.coordinator().calls().jobs.CancelJob(cancel).ok());
  cluster.Restart();
  EXPECT_EQ(FilesBelow(cluster.folder() / "work/jobs"), 0);
}

TEST(RestoreJobsTest, AResultOfTheTimeBeforeIsRefused) {
  TestCluster cluster(Durable());
  const std::string name = cluster.Submit("toy://1x1").name();
  v1::SyncRequest request;
  request.set_protocol(kProtocolVersion);
  request.set_worker("w");
  request.set_threads(1);
  request.set_wait_ms(1000);
  const auto alive = [] { return true; };
  v1::SyncResponse response;
  while (response.start().empty()) {
    request.set_sequence(request.sequence() + 1);
    response = *SyncAndWait(cluster.coordinator().calls().work, request, alive);
  }
  const v1::TaskRef old = response.start(0).ref();
  cluster.Restart();
  v1::FinishedTask& finished = *request.add_finished();
  *finished.mutable_ref() = old;
  finished.mutable_output()->set_content("1");
  finished.mutable_output()->set_size(1);
  response.Clear();
  while (response.start().empty()) {
    request.set_sequence(request.sequence() + 1);
    response = *SyncAndWait(cluster.coordinator().calls().work, request, alive);
  }
  EXPECT_NE(response.start(0).ref().attempt_token(), old.attempt_token());
  EXPECT_EQ(cluster.Get(name).progress().tasks_done(), 0);
}

// Waits for workers that see a file that is not there.
class Elsewhere : public JobPipeline {
 public:
  absl::StatusOr<JobFolders> Folders() const override { return JobFolders{{{"/nowhere/at all", "print"}}, ""}; }
  absl::StatusOr<std::vector<NewTask>> Start() override { return std::vector<NewTask>{{{0, 0}, Stage::kSurvey, "in"}}; }
  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult) override { return std::vector<NewTask>(); }
  bool Done() const override { return false; }
  Progress GetProgress() const override { return {}; }
  absl::StatusOr<JobOutcome> Finish() override { return JobOutcome(); }
};

TEST(RestoreJobsTest, WarningsAreRemembered) {
  ClusterOptions options = Durable();
  options.factory = [](const JobSpec&, const std::stop_token&) { return std::make_unique<Elsewhere>(); };
  TestCluster cluster(options);
  cluster.AddWorker("w");
  const std::string name = cluster.Submit("toy://1x1").name();
  ASSERT_FALSE(name.empty());
  while (cluster.Get(name).warnings().empty()) std::this_thread::yield();
  const std::string warning = cluster.Get(name).warnings(0);
  cluster.Restart();
  ASSERT_EQ(cluster.Get(name).warnings_size(), 1);
  EXPECT_EQ(cluster.Get(name).warnings(0), warning);
}

// Of a job that is over: can do nothing but release.
class Releasing : public JobPipeline {
 public:
  explicit Releasing(std::atomic<int>& count) : count_(count) {}
  absl::StatusOr<std::vector<NewTask>> Start() override { return absl::InternalError("it is over"); }
  absl::StatusOr<std::vector<NewTask>> OnTaskDone(TaskResult) override { return absl::InternalError("it is over"); }
  bool Done() const override { return true; }
  Progress GetProgress() const override { return {}; }
  absl::StatusOr<JobOutcome> Finish() override { return absl::InternalError("it is over"); }
  void Release() override { ++count_; }

 private:
  std::atomic<int>& count_;
};

// Between the end that is durable and the release of the output.
TEST(RestoreJobsTest, AnOutputThatWasNotReleasedIs) {
  TempFolder folder;
  std::atomic<int> released{0};
  v1::Job told;
  told.set_name("jobs/x");
  told.set_state(v1::DONE);
  told.mutable_spec()->set_scene("s");
  told.mutable_spec()->set_out("o");
  for (const int expected : {1, 1}) {
    auto journal = *OpenSqliteJournal(folder / "journal");
    if (journal->epoch() == 1) {
      journal->PutJob({.number = 1, .body = told.SerializeAsString(), .over = true});
      journal.reset();
      journal = *OpenSqliteJournal(folder / "journal");
    }
    CoordinatorOptions options;
    options.work_folder = folder / "work";
    options.journal = std::move(journal);
    options.background_ticks = false;
    const auto coordinator = Coordinator::Create(
        std::move(options),
        [&](const JobSpec&, const std::stop_token&) { return std::make_unique<Releasing>(released); },
        *MetricsRegistry::Null());
    ASSERT_TRUE(coordinator.ok()) << coordinator.status();
    v1::GetJobRequest get;
    get.set_name("jobs/x");
    EXPECT_EQ((*coordinator)->calls().jobs.GetJob(get)->state(), v1::DONE);
    while (released < expected) absl::SleepFor(absl::Milliseconds(1));
    EXPECT_EQ(released, expected);
  }
}

void Damage(const std::string& journal, const std::string& sql) {
  auto database = OpenJournalFile(journal);
  ASSERT_TRUE(database.ok()) << database.status();
  database->exec(sql);
}

class DamagedJournalTest : public ::testing::TestWithParam<const char*> {};

TEST_P(DamagedJournalTest, OneJobsDamageIsNotThatOfAnother) {
  TestCluster cluster(Durable());
  Budget budget(6);
  cluster.AddWorker("first", 1, budget.Runner());
  cluster.Submit("toy://2x2?bytes=100000");
  const std::string good = cluster.Submit("toy://2x2").name();
  budget.AwaitEnd();
  cluster.Restart([](const std::string& journal) { Damage(journal, GetParam()); });
  v1::ListJobsResponse list = *cluster.coordinator().calls().jobs.ListJobs({});
  ASSERT_EQ(list.jobs_size(), 2);
  const v1::Job& damaged = list.jobs(1);
  cluster.AddWorker("second", 2);
  EXPECT_EQ(cluster.WaitFor(good).state(), v1::DONE);
  const v1::Job failed = cluster.WaitFor(damaged.name());
  EXPECT_EQ(failed.state(), v1::FAILED);
  EXPECT_NE(failed.error().message().find("damaged"), std::string::npos) << failed.error().message();
  cluster.Restart();
  EXPECT_EQ(cluster.Get(damaged.name()).state(), v1::FAILED) << "it is put down";
  EXPECT_EQ(cluster.Get(good).state(), v1::DONE);
}

INSTANTIATE_TEST_SUITE_P(Rows, DamagedJournalTest,
                         ::testing::Values("UPDATE job SET body = x'0102' WHERE number = 1",
                                           "UPDATE job SET request_id = x'00' WHERE number = 1",
                                           "UPDATE result SET sum = x'00' WHERE job = 1",
                                           "UPDATE result SET output = x'00' WHERE job = 1"));

TEST(RestoreJobsTest, WhoWasSetAsideStaysSo) {
  ClusterOptions options = Durable();
  options.check_result = [](Stage, const std::string&, const std::string& output) {
    return output == "lie" ? absl::DataLossError("a lie") : absl::OkStatus();
  };
  TestCluster cluster(options);
  v1::SyncRequest request;
  request.set_protocol(kProtocolVersion);
  request.set_worker("liar");
  request.set_threads(1);
  request.set_wait_ms(1000);
  const auto alive = [] { return true; };
  v1::SyncResponse response;
  const std::string name = cluster.Submit("toy://1x1").name();
  while (response.start().empty()) {
    request.set_sequence(request.sequence() + 1);
    response = *SyncAndWait(cluster.coordinator().calls().work, request, alive);
  }
  v1::FinishedTask& finished = *request.add_finished();
  *finished.mutable_ref() = response.start(0).ref();
  finished.mutable_output()->set_content("lie");
  finished.mutable_output()->set_size(3);
  request.set_sequence(request.sequence() + 1);
  EXPECT_EQ(SyncAndWait(cluster.coordinator().calls().work, request, alive)->set_aside(), "")
      << "nobody is known to do better";
  cluster.AddWorker("good");
  EXPECT_EQ(cluster.WaitFor(name).state(), v1::DONE);
  cluster.Restart();
  request.clear_finished();
  request.set_sequence(request.sequence() + 1);
  response = *SyncAndWait(cluster.coordinator().calls().work, request, alive);
  EXPECT_NE(response.set_aside().find("a lie"), std::string::npos) << response.set_aside();
}

}  // namespace
}  // namespace tilemend
