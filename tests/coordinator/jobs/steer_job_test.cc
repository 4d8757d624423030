// Priorities and pauses of jobs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class SteerJobTest : public CoordinatorTest {
 protected:
  absl::StatusOr<v1::Job> Pause(const v1::Job& job) {
    v1::PauseJobRequest request;
    request.set_name(job.name());
    return calls_.jobs.PauseJob(request);
  }
  absl::StatusOr<v1::Job> Resume(const v1::Job& job) {
    v1::ResumeJobRequest request;
    request.set_name(job.name());
    return calls_.jobs.ResumeJob(request);
  }
  absl::StatusOr<v1::Job> Prioritize(const v1::Job& job, int32_t priority) {
    v1::PrioritizeJobRequest request;
    request.set_name(job.name());
    request.set_priority(priority);
    return calls_.jobs.PrioritizeJob(request);
  }
};

TEST_F(SteerJobTest, APausedJobGivesOutNoTasksAndSaysSo) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  const auto paused = Pause(job);
  ASSERT_TRUE(paused.ok()) << paused.status();
  EXPECT_TRUE(paused->paused());
  EXPECT_GT(paused->cursor(), job.cursor()) << "who watches it hears of it";
  EXPECT_THAT(paused->waiting(), HasSubstr("paused"));
  v1::SyncRequest request = NewSync("w");
  request.set_wait_ms(0);
  EXPECT_EQ(Sync(request).start_size(), 0);
  const auto resumed = Resume(job);
  ASSERT_TRUE(resumed.ok()) << resumed.status();
  EXPECT_FALSE(resumed->paused());
  AwaitTask();
}

TEST_F(SteerJobTest, PausingTwiceIsAsOnce) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  const auto once = Pause(job), twice = Pause(job);
  ASSERT_TRUE(twice.ok()) << twice.status();
  EXPECT_TRUE(twice->paused());
}

TEST_F(SteerJobTest, AJobIsMadeWithAPriorityAndGetsAnother) {
  v1::CreateJobRequest request = NewRequest();
  request.set_priority(-3);
  const auto job = calls_.jobs.CreateJob(request);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->priority(), -3);
  EXPECT_EQ(Prioritize(*job, 7)->priority(), 7);
  EXPECT_EQ(cluster_.Get(job->name()).priority(), 7);
}

TEST_F(SteerJobTest, PrioritiesHaveLimits) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  EXPECT_EQ(ErrorReason(Prioritize(job, 101).status()), "INVALID_PRIORITY");
  v1::CreateJobRequest request = NewRequest();
  request.set_priority(-101);
  EXPECT_EQ(ErrorReason(calls_.jobs.CreateJob(request).status()), "INVALID_PRIORITY");
}

TEST_F(SteerJobTest, AJobThatIsOverIsNotSteered) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  v1::CancelJobRequest cancel;
  cancel.set_name(job.name());
  ASSERT_TRUE(calls_.jobs.CancelJob(cancel).ok());
  EXPECT_EQ(ErrorReason(Pause(job).status()), "JOB_OVER");
  EXPECT_EQ(ErrorReason(Prioritize(job, 1).status()), "JOB_OVER");
}

TEST_F(SteerJobTest, APausedJobIsCancelled) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  ASSERT_TRUE(Pause(job).ok());
  v1::CancelJobRequest cancel;
  cancel.set_name(job.name());
  const auto cancelled = calls_.jobs.CancelJob(cancel);
  ASSERT_TRUE(cancelled.ok()) << cancelled.status();
  EXPECT_EQ(cancelled->state(), v1::CANCELLED);
}

}  // namespace
}  // namespace tilemend
