// What workers say takes effect, without gRPC.
#include "coordinator/api/worker_reports.h"

#include <gtest/gtest.h>

#include <string>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/waiting_sync.h"

namespace tilemend {
namespace {

using WorkerReportsTest = CoordinatorTest;

TEST_F(WorkerReportsTest, AStrangerCannotRenewALease) {
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

TEST_F(WorkerReportsTest, AWorkersNameIsItsOwn) {
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

TEST_F(WorkerReportsTest, ALateCallOfAWorkerThatHasLeftGetsNoTask) {
  const v1::SyncRequest late = NewSync();
  v1::SyncRequest last = NewSync();
  last.set_draining(true);
  EXPECT_TRUE(Sync(last).leave());
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  EXPECT_TRUE(absl::IsAborted(SyncAndWait(calls_.work, late).status()));
  EXPECT_EQ(calls_.cluster.ListWorkers({})->workers_size(), 0);
  AwaitTask();  // of a new one of that name
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
