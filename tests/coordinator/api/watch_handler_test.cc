// Calls that follow jobs and the demand, without gRPC.
#include "coordinator/api/watch_handler.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

using WatchHandlerTest = CoordinatorTest;

absl::Status Always() { return absl::OkStatus(); }

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
  EXPECT_TRUE(calls_.watch.WatchJob(watch, send, Always).ok());
  EXPECT_EQ(told, (std::vector<v1::JobState>{v1::RUNNING, v1::CANCELLED}));
}

TEST_F(WatchHandlerTest, KnowsItsJobs) {
  v1::WatchJobRequest watch;
  watch.set_name("jobs/none");
  EXPECT_EQ(ErrorReason(calls_.watch.WatchJob(
                watch, [](const v1::Job&) { return true; }, Always)),
            "JOB_NOT_FOUND");
}

TEST_F(WatchHandlerTest, TellsWhenThereIsSomethingToDo) {
  std::vector<bool> told;
  const auto send = [&](bool active) {
    told.push_back(active);
    if (!active) cluster_.Submit("toy://2x1");
    return !active;
  };
  EXPECT_TRUE(absl::IsCancelled(calls_.watch.WatchDemand(send, Always)));
  EXPECT_EQ(told, (std::vector<bool>{false, true}));
}

TEST_F(WatchHandlerTest, EndsWhenItsCallerMayNotWatchAnyMore) {
  v1::WatchJobRequest watch;
  watch.set_name(cluster_.Submit("toy://2x1").name());
  const auto send = [](const v1::Job&) { return true; };
  EXPECT_TRUE(absl::IsUnauthenticated(
      calls_.watch.WatchJob(watch, send, [] { return absl::UnauthenticatedError("the token has expired"); })));
}

TEST_F(WatchHandlerTest, EndsWithTheCoordinator) {
  coordinator_.StopWaiting();
  EXPECT_TRUE(absl::IsUnavailable(calls_.watch.WatchDemand([](bool) { return true; }, Always)));
}

}  // namespace
}  // namespace tilemend
