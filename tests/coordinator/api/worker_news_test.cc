// What workers are told, without gRPC.
#include "coordinator/api/worker_news.h"

#include <gtest/gtest.h>

#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/waiting_sync.h"

namespace tilemend {
namespace {

using WorkerNewsTest = CoordinatorTest;

TEST_F(WorkerNewsTest, TellsALostAnswerAgain) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  const v1::Task task = AwaitTask();
  const v1::SyncResponse again = Sync(NewSync());  // says that it holds nothing
  ASSERT_EQ(again.start_size(), 1);
  EXPECT_EQ(again.start(0).SerializeAsString(), task.SerializeAsString());
}

TEST_F(WorkerNewsTest, TellsToDropWhatIsNoLongerLeased) {
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

TEST_F(WorkerNewsTest, LeasesNothingToAWorkerThatIsGone) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  AwaitTask("first");
  EXPECT_TRUE(absl::IsCancelled(SyncAndWait(calls_.work, NewSync("gone"), [] { return false; }).status()));
  EXPECT_EQ(AwaitTask("second").ref().task(), 2);
}

TEST_F(WorkerNewsTest, ReleasesADrainingWorker) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest()).ok());
  AwaitTask();
  v1::SyncRequest request = NewSync();
  request.set_draining(true);
  EXPECT_TRUE(Sync(request).leave());
  EXPECT_EQ(AwaitTask("other").attempt(), 2);
}

}  // namespace
}  // namespace tilemend
