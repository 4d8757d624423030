// The worker's calls, without workers and without gRPC.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "common/util/error_info.h"
#include "coordinator/store/blob_folder.h"
#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/list_log.h"
#include "tests/support/waiting_sync.h"

namespace tilemend {
namespace {

using ::testing::StartsWith;
using WorkHandlerTest = CoordinatorTest;

TEST_F(WorkHandlerTest, TellsALostAnswerAgain) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::Task task = AwaitTask();
  const v1::SyncResponse again = Sync(NewSync());  // says that it holds nothing
  ASSERT_EQ(again.start_size(), 1);
  EXPECT_EQ(again.start(0).SerializeAsString(), task.SerializeAsString());
}

TEST_F(WorkHandlerTest, TellsToDropWhatIsNoLongerLeased) {
  const auto job = calls_.jobs.CreateJob(NewRequest());
  const v1::Task task = AwaitTask();
  v1::SyncRequest holding = NewSync();
  *holding.add_held() = task.ref();
  holding.set_wait_ms(0);
  EXPECT_EQ(Sync(holding).keep_size(), 1);
  v1::CancelJobRequest cancel;
  cancel.set_name(job->name());
  ASSERT_TRUE(calls_.jobs.CancelJob(cancel).ok());
  holding.set_sequence(++sequence_);
  EXPECT_EQ(Sync(holding).keep_size(), 0);
}

TEST_F(WorkHandlerTest, AnInputThatWasLostIsNotTakenForAnEmptyOne) {
  BlobFolder other(cluster_.folder() / "other");
  ASSERT_TRUE(other.Hold(std::string(kMostHeldBytes, 'x')).ok());  // so that inputs are files
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::Task task = AwaitTask();
  ASSERT_EQ(task.input().size(), static_cast<int64_t>(task.input().content().size()));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(cluster_.folder() / "work/jobs")) {
    if (entry.is_regular_file()) std::filesystem::remove(entry.path());
  }
  const v1::Task again = AwaitTask();
  EXPECT_EQ(again.ref().task(), task.ref().task());
  EXPECT_EQ(again.input().size(), -1);
}

TEST_F(WorkHandlerTest, LeasesNothingToAWorkerThatIsGone) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  AwaitTask("first");
  EXPECT_TRUE(absl::IsCancelled(SyncAndWait(calls_.work, NewSync("gone"), [] { return false; }).status()));
  EXPECT_EQ(AwaitTask("second").ref().task(), 2);
}

TEST_F(WorkHandlerTest, RefusesAnotherProtocol) {
  v1::SyncRequest request = NewSync();
  request.set_protocol(kProtocolVersion + 1);
  EXPECT_EQ(ErrorReason(SyncAndWait(calls_.work, request).status()), "PROTOCOL_VERSION");
}

TEST(WorkLogTest, NamesAWorkerOfAnotherProtocolWhateverItSays) {
  ListLog log;
  ClusterOptions options;
  options.log = &log;
  TestCluster cluster(options);
  v1::SyncRequest request;
  request.set_protocol(kProtocolVersion - 1);
  request.set_worker("old-" + std::string(5000, 'w'));
  request.set_threads(-1);
  const absl::Status refused = SyncAndWait(cluster.coordinator().calls().work, request).status();
  EXPECT_EQ(ErrorReason(refused), "PROTOCOL_VERSION");
  EXPECT_LT(refused.message().size(), 500U);
  ASSERT_EQ(log.lines().size(), 1U);
  EXPECT_THAT(log.lines().front(), StartsWith("warning worker refused worker=old-www"));
  EXPECT_LT(log.lines().front().size(), 1000U);
}

TEST(WorkLogTest, NamesAWorkerOfAnotherBuild) {
  ListLog log;
  ClusterOptions options;
  options.log = &log;
  options.build = "aaaa";
  TestCluster cluster(options);
  v1::SyncRequest request;
  request.set_protocol(kProtocolVersion);
  request.set_worker("w");
  request.set_release("0.0.9");
  request.set_threads(1);
  request.set_build("bbbb");
  const auto alive = [] { return true; };
  const absl::Status refused = SyncAndWait(cluster.coordinator().calls().work, request, alive).status();
  EXPECT_EQ(ErrorReason(refused), "OTHER_BUILD");
  EXPECT_THAT(std::string(refused.message()),
              StartsWith("worker w is of build bbbb (0.0.9), this coordinator of aaaa"));
  ASSERT_EQ(log.lines().size(), 1U);
  EXPECT_THAT(log.lines().front(), StartsWith("warning worker refused worker=w worker_release=0.0.9"));
  EXPECT_TRUE(cluster.coordinator().calls().cluster.ListWorkers({})->workers().empty());
  request.set_build("aaaa");
  EXPECT_TRUE(SyncAndWait(cluster.coordinator().calls().work, request, alive).ok());
}

TEST_F(WorkHandlerTest, ReleasesADrainingWorker) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  AwaitTask();
  v1::SyncRequest request = NewSync();
  request.set_draining(true);
  EXPECT_TRUE(Sync(request).leave());
  EXPECT_EQ(AwaitTask("other").attempt(), 2);
}

TEST_F(WorkHandlerTest, AStrangerCannotRenewALease) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::Task task = AwaitTask("holder");
  cluster_.clock().Advance(absl::Seconds(8));
  v1::SyncRequest stranger = NewSync("stranger", 0);
  *stranger.add_held() = task.ref();
  stranger.set_wait_ms(0);
  Sync(stranger);
  cluster_.clock().Advance(absl::Seconds(8));
  coordinator_.Tick();
  EXPECT_EQ(AwaitTask("other").ref().task(), task.ref().task());
}

TEST_F(WorkHandlerTest, AWorkersNameIsItsOwn) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  v1::SyncRequest first = NewSync();
  first.set_secret("mine");
  Sync(first);
  for (const char* secret : {"", "guessed"}) {
    v1::SyncRequest stranger = NewSync();
    stranger.set_secret(secret);
    EXPECT_EQ(ErrorReason(SyncAndWait(calls_.work, stranger).status()), "WORKER_SECRET");
  }
  first.set_sequence(++sequence_);
  Sync(first);
}

TEST_F(WorkHandlerTest, RefusesNamesWithoutEnd) {
  v1::SyncRequest talker = NewSync(std::string(257, 'w'));
  EXPECT_TRUE(absl::IsInvalidArgument(SyncAndWait(calls_.work, talker).status()));
  talker = NewSync();
  talker.set_secret(std::string(257, 's'));
  EXPECT_TRUE(absl::IsInvalidArgument(SyncAndWait(calls_.work, talker).status()));
  talker = NewSync();
  talker.set_release(std::string(257, 'r'));
  EXPECT_TRUE(absl::IsInvalidArgument(SyncAndWait(calls_.work, talker).status()));
}

class LookingWorkerTest : public CoordinatorTest {
 protected:
  static ClusterOptions Seen() {
    ClusterOptions options = Options();
    options.factory = ToysWithFolders({{{"/scene.json", "print"}}, ""});
    return options;
  }

  LookingWorkerTest() : CoordinatorTest(Seen()) {}

  void Look(const std::string& job) {
    v1::SyncRequest request = NewSync("stuck");
    request.set_wait_ms(0);
    v1::FoldersSeen& seen = *request.add_seen();
    seen.set_job(job);
    seen.set_looking(true);
    Sync(request);
  }

  // A worker that sees the file takes a task, another one looks for `looks`, and the first says that it cannot be done.
  v1::Job AfterAFailure(absl::Duration looks) {
    v1::CreateJobRequest asked = NewRequest(absl::StrCat("o", absl::ToInt64Seconds(looks)));
    const std::string name = calls_.jobs.CreateJob(asked)->name(), job = name.substr(name.find('/') + 1);
    v1::SyncResponse told;
    for (int i = 0; i < 20 && told.look_size() == 0; ++i) told = Sync(NewSync("sound"));
    v1::SyncRequest request = NewSync("sound");
    v1::FoldersSeen& seen = *request.add_seen();
    seen.set_job(job);
    seen.add_files()->set_fingerprint("print");
    told = Sync(request);
    EXPECT_EQ(told.start_size(), 1);
    Look(job);
    cluster_.clock().Advance(looks);
    Look(job);
    request = NewSync("sound", 0);
    auto* finished = request.add_finished();
    *finished->mutable_ref() = told.start(0).ref();
    finished->set_stage(told.start(0).stage());
    finished->mutable_error()->set_code(static_cast<int>(absl::StatusCode::kInvalidArgument));
    finished->mutable_error()->set_message("cannot be read");
    Sync(request);
    return cluster_.Get(name);
  }
};

TEST_F(LookingWorkerTest, ATaskThatFailedWaitsForItUnlessItSeemsStuck) {
  EXPECT_EQ(AfterAFailure(absl::Seconds(1)).progress().tasks_retried(), 1);
  EXPECT_EQ(AfterAFailure(absl::Seconds(6)).progress().tasks_retried(), 0);
}

TEST(FullOutputTest, AJobThatTheCoordinatorCannotWriteForEitherFails) {
  ClusterOptions options;
  options.factory = ToysWithFolders({{}, "/proc/self"});  // nobody can write there
  TestCluster cluster(options);
  cluster.AddWorker("w");
  const v1::Job job = cluster.WaitFor(cluster.Submit("toy://1x1").name());
  EXPECT_EQ(job.state(), v1::FAILED);
  EXPECT_NE(job.error().message().find("/proc/self"), std::string::npos) << job.error().message();
}

}  // namespace
}  // namespace tilemend
