// Jobs that are started.
#include "coordinator/jobs/job_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

using JobRunsTest = CoordinatorTest;

TEST_F(JobRunsTest, TheSameRequestIdGivesTheSameJob) {
  v1::CreateJobRequest request = NewRequest();
  request.set_request_id("r");
  const auto first = calls_.jobs.CreateJob(request);
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_EQ(calls_.jobs.CreateJob(request)->name(), first->name());
  request.mutable_spec()->set_uniform(true);
  EXPECT_EQ(ErrorReason(calls_.jobs.CreateJob(request).status()), "REQUEST_ID_REUSED");
}

TEST_F(JobRunsTest, RefusesASecondWriterToAFolder) {
  ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest("o")).ok());
  EXPECT_EQ(ErrorReason(calls_.jobs.CreateJob(NewRequest("x/../o/")).status()), "OUTPUT_IN_USE");
}

TEST_F(JobRunsTest, RefusesMoreJobsThanItsLimit) {
  for (const char* out : {"1", "2", "3"}) ASSERT_TRUE(calls_.jobs.CreateJob(NewRequest(out)).ok());
  EXPECT_EQ(ErrorReason(calls_.jobs.CreateJob(NewRequest("4")).status()), "TOO_MANY_JOBS");
}

}  // namespace
}  // namespace tilemend
