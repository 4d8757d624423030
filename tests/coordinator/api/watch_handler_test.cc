// Calls that follow jobs and the demand, without gRPC.
#include "coordinator/api/watch_handler.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/waiting_watch.h"

namespace tilemend {
namespace {

using WatchHandlerTest = CoordinatorTest;

TEST_F(WatchHandlerTest, EndsWithTheJob) {
  v1::CancelJobRequest cancel;
  cancel.set_name(cluster_.Submit("toy://2x1").name());
  v1::WatchJobRequest watch;
  watch.set_name(cancel.name());
  std::vector<v1::JobState> told;
  const auto send = [&](const v1::Job& job) {
    told.push_back(job.state());
    return calls_.jobs.CancelJob(cancel).ok();
  };
  EXPECT_TRUE(WatchAndWait(calls_.watch, watch, send).ok());
  EXPECT_EQ(told, (std::vector<v1::JobState>{v1::RUNNING, v1::CANCELLED}));
}

TEST_F(WatchHandlerTest, KnowsItsJobs) {
  v1::WatchJobRequest watch;
  watch.set_name("jobs/none");
  EXPECT_EQ(ErrorReason(WatchAndWait(calls_.watch, watch, [](const v1::Job&) { return true; })), "JOB_NOT_FOUND");
}

TEST_F(WatchHandlerTest, TellsWhenThereIsSomethingToDo) {
  std::vector<bool> told;
  const auto send = [&](bool active) {
    told.push_back(active);
    if (!active) cluster_.Submit("toy://2x1");
    return !active;
  };
  EXPECT_TRUE(absl::IsCancelled(WatchDemandAndWait(calls_.watch, send)));
  EXPECT_EQ(told, (std::vector<bool>{false, true}));
}

TEST_F(WatchHandlerTest, EndsWhenItsCallerMayNotWatchAnyMore) {
  v1::WatchJobRequest watch;
  watch.set_name(cluster_.Submit("toy://2x1").name());
  const auto send = [](const v1::Job&) { return true; };
  EXPECT_TRUE(absl::IsUnauthenticated(
      WatchAndWait(calls_.watch, watch, send, [] { return absl::UnauthenticatedError("the token has expired"); })));
}

TEST_F(WatchHandlerTest, EndsWithTheCoordinator) {
  coordinator_.StopWaiting();
  EXPECT_TRUE(absl::IsUnavailable(WatchDemandAndWait(calls_.watch, [](bool) { return true; })));
}

}  // namespace
}  // namespace tilemend
