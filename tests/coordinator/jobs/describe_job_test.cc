// What a job says of itself.
#include "coordinator/jobs/describe_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/waiting_watch.h"

namespace tilemend {
namespace {

using DescribeJobTest = CoordinatorTest;

TEST_F(DescribeJobTest, SaysThatAJobWaitsForWorkers) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  v1::WatchJobRequest watch;
  watch.set_name(job.name());
  std::string waiting;
  const auto until_it_waits = [&waiting](const v1::Job& now) { return (waiting = now.waiting()).empty(); };
  EXPECT_TRUE(absl::IsCancelled(WatchAndWait(calls_.watch, watch, until_it_waits)));
  EXPECT_EQ(waiting, "no worker is connected");
  AwaitTask();
  EXPECT_EQ(cluster_.Get(job.name()).waiting(), "");
}

TEST_F(DescribeJobTest, TellsWhenAJobStartedAndItsTrace) {
  const v1::Job job = cluster_.Submit("toy://2x1");
  EXPECT_FALSE(job.has_start_time());
  EXPECT_EQ(job.trace().size(), 32U);
  cluster_.clock().Advance(absl::Seconds(5));
  const v1::Task task = AwaitTask();
  EXPECT_EQ(task.trace(), job.trace());
  const v1::Job started = cluster_.Get(job.name());
  EXPECT_EQ(started.start_time().seconds() - started.create_time().seconds(), 5);
}

}  // namespace
}  // namespace tilemend
