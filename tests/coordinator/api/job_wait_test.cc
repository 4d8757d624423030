#include "coordinator/api/job_wait.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "absl/synchronization/notification.h"
#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

class JobWaitTest : public CoordinatorTest {
 protected:
  // Of a state that never comes.
  v1::WatchJobRequest EndOf(const std::string& name) {
    v1::WatchJobRequest request;
    request.set_name(name);
    request.set_cursor(UINT64_MAX);
    return request;
  }
  void Cancel(const std::string& name) {
    v1::CancelJobRequest request;
    request.set_name(name);
    EXPECT_TRUE(calls_.jobs.CancelJob(request).ok());
  }
  static absl::Status GoOn() { return absl::OkStatus(); }
};

TEST_F(JobWaitTest, WakesOnceWhenTheJobIsOver) {
  const std::string job = cluster_.Submit("toy://2x1").name();
  absl::Notification woken;
  const auto wait = AwaitJob(calls_.watch, EndOf(job), GoOn, [&] { woken.Notify(); });  // a second Notify aborts
  Cancel(job);
  EXPECT_TRUE(woken.WaitForNotificationWithTimeout(kLongestJobWait / 2));
}

TEST_F(JobWaitTest, WakesAtOnceForAJobThatIsNotThere) {
  bool woken = false;
  const auto wait = AwaitJob(calls_.watch, EndOf("jobs/none"), GoOn, [&] { woken = true; });
  EXPECT_TRUE(woken);
}

TEST_F(JobWaitTest, WakesWhenItsCallerMayNotGoOn) {
  const std::string job = cluster_.Submit("toy://2x1").name();
  absl::Notification woken;
  const auto wait = AwaitJob(
      calls_.watch, EndOf(job), [] { return absl::UnauthenticatedError("expired"); }, [&] { woken.Notify(); });
  EXPECT_TRUE(woken.WaitForNotificationWithTimeout(kLongestJobWait / 2));
}

TEST_F(JobWaitTest, CallsNothingOnceItIsLetGo) {
  const std::string job = cluster_.Submit("toy://2x1").name();
  std::atomic<bool> woken = false;
  for (int i = 0; i < 100; ++i) AwaitJob(calls_.watch, EndOf(job), GoOn, [&] { woken = true; });
  absl::Notification last;
  const auto wait = AwaitJob(calls_.watch, EndOf(job), GoOn, [&] { last.Notify(); });
  Cancel(job);
  EXPECT_TRUE(last.WaitForNotificationWithTimeout(kLongestJobWait / 2));
  EXPECT_FALSE(woken);
}

}  // namespace
}  // namespace tilemend
