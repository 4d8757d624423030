#include "coordinator/jobs/job_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/known_jobs.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class JobMetricsTest : public KnownJobsTest {
 protected:
  JobMetrics metrics_{registry_};
};

TEST_F(JobMetricsTest, CountsJobsOfEarlierProcesses) {
  const Job& job = NewJob("j");
  ASSERT_TRUE(state_.Apply(JobFinished{"j", JobState::kFailed, start_ + absl::Seconds(9)}).ok());
  metrics_.CountEnd(job);
  ExpectLine("jobs_ended_total{state=\"failed\"} 1");
}

TEST_F(JobMetricsTest, ShowsNoJobBeforeItKnowsAny) {
  ExpectLine("running_job_done_ratio{slot=\"1\"} Nan");
  ExpectLine("running_job_age_seconds{slot=\"16\"} Nan");
}

TEST_F(JobMetricsTest, GivesEachRunningJobASlotForItsTime) {
  NewJob("a");
  NewJob("b");
  EXPECT_EQ(metrics_.SlotOf("a"), 0);
  metrics_.Show(state_, start_ + absl::Seconds(5));
  EXPECT_EQ(metrics_.SlotOf("a"), 1);
  EXPECT_EQ(metrics_.SlotOf("b"), 2);
  ExpectLine("running_job_done_ratio{slot=\"2\"} 0");
  ExpectLine("running_job_age_seconds{slot=\"1\"} 5");
  ASSERT_TRUE(state_.Apply(JobCancelled{"a", start_}).ok());
  NewJob("c");
  metrics_.Show(state_, start_ + absl::Seconds(6));
  EXPECT_EQ(metrics_.SlotOf("a"), 0);
  EXPECT_EQ(metrics_.SlotOf("b"), 2);  // keeps it
  EXPECT_EQ(metrics_.SlotOf("c"), 1);
  ExpectLine("running_job_done_ratio{slot=\"3\"} Nan");
}

TEST_F(JobMetricsTest, HasNoMoreSlotsThanItSays) {
  for (size_t i = 0; i < JobMetrics::kSlots + 1; ++i) NewJob(absl::StrCat("job", i));
  metrics_.Show(state_, start_);
  EXPECT_EQ(metrics_.SlotOf(absl::StrCat("job", JobMetrics::kSlots)), 0);
}

TEST_F(JobMetricsTest, CountsHolesOnceThoughAJobTellsThemAgain) {
  NewJob("j");
  for (const int64_t filled : {3, 1, 5}) {
    ASSERT_TRUE(state_.Apply(JobProgressed{"j", {"fill", 2, 0, 9, filled}}).ok());
    metrics_.Show(state_, start_);
  }
  ExpectLine("holes_filled_total 5");
}

TEST(ShareDoneTest, IsAllOnlyAtTheEnd) {
  Job job;
  EXPECT_EQ(ShareDone(job), 0);
  job.progress.phase = "survey";
  job.progress.cells = 10;
  job.counts.added = job.counts.committed = 10;  // as many cells to fill and to assemble are to come
  EXPECT_EQ(ShareDone(job), 10 / 30.0);
  job.progress.phase = "fill";
  job.counts.added = job.counts.committed = 20;
  EXPECT_EQ(ShareDone(job), 20 / 30.0);
  job.progress.phase = "assemble";
  job.counts.added = 30;
  EXPECT_EQ(ShareDone(job), 20 / 30.0);
  job.state = JobState::kDone;
  EXPECT_EQ(ShareDone(job), 1);
}

TEST(ShareDoneTest, CountsTasksThatAreHeldBack) {
  constexpr int64_t kCells = 100'000, kOut = kMostTasksOut;
  EXPECT_EQ(ShareDone("survey", kCells, 0, kOut + 10'000, 10'000), 1 / 30.0);
  EXPECT_EQ(ShareDone("assemble", kCells, 50'000, 150'000 + kOut, 150'000), .75);
  EXPECT_EQ(ShareDone("assemble", kCells, kCells - 500, 200'000, 199'500), 199'500 / 200'000.0) << "all are out";
  EXPECT_EQ(ShareDone(kVerifyPhase, 10, 10, 32, 31), 31 / 32.0);
}

// The page of the coordinator is held to the same table (tests/web/times_test.mjs).
TEST(ShareDoneTest, IsWhatThePageTells) {
  std::ifstream table(SHARE_TABLE);
  int rows = 0;
  for (std::string line; std::getline(table, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream row(line);
    std::string phase;
    int64_t cells = 0, cells_done = 0, tasks = 0, tasks_done = 0;
    double done = 0, of = 0;
    char slash = 0;
    ASSERT_TRUE(row >> phase >> cells >> cells_done >> tasks >> tasks_done >> done >> slash >> of) << line;
    EXPECT_EQ(ShareDone(phase, cells, cells_done, tasks, tasks_done), done / of) << line;
    ++rows;
  }
  EXPECT_GT(rows, 10);
}

}  // namespace
}  // namespace tilemend
