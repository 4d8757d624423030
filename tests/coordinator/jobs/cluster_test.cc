// Names of jobs.
#include "coordinator/jobs/cluster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

using ClusterTest = CoordinatorTest;

TEST_F(ClusterTest, NamesWhatItDoesNotKnow) {
  v1::GetJobRequest get;
  get.set_name("jobs/none");
  EXPECT_EQ(ErrorReason(calls_.jobs.GetJob(get).status()), "JOB_NOT_FOUND");
  get.set_name("none");
  EXPECT_EQ(ErrorReason(calls_.jobs.GetJob(get).status()), "INVALID_NAME");
}

}  // namespace
}  // namespace tilemend
