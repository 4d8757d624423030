#include "coordinator/jobs/cluster_events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/metrics/prometheus_registry.h"
#include "tests/support/list_log.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const absl::Time kStart = absl::FromUnixSeconds(1000);

class ClusterEventsTest : public ::testing::Test {
 protected:
  void ExpectLine(const std::string& line) {
    EXPECT_THAT(registry_.Text(), HasSubstr(absl::StrCat("tilemend_coordinator_", line, "\n")));
  }
  // A job that the state machine knows, with `tasks` tasks of two cells.
  const Job& NewJob(const std::string& id, size_t tasks = 2) {
    EXPECT_TRUE(state_.Apply(JobCreated{id, "", kStart}).ok());
    EXPECT_TRUE(state_.Apply(JobProgressed{id, {"survey", 2, 0, 0, 0}}).ok());
    EXPECT_TRUE(state_.Apply(TasksAdded{id, std::vector<TaskSpec>(tasks)}).ok());
    return *state_.FindJob(id);
  }

  PrometheusRegistry registry_;
  ListLog log_;
  ClusterEvents events_{registry_, log_};
  CoordinatorState state_;
};

TEST_F(ClusterEventsTest, SaysAndCountsHowAJobEnded) {
  const Job& job = NewJob("j");
  ASSERT_TRUE(state_.Apply(JobProgressed{"j", {"assemble", 2, 2, 5, 4, 300}}).ok());
  ASSERT_TRUE(state_.Apply(JobFinished{"j", JobState::kPartial, kStart + absl::Seconds(90)}).ok());
  events_.JobEnded(job, {true, "4 of 5 holes filled", ""}, absl::OkStatus(), {"ann", "t1"});
  EXPECT_THAT(log_.lines(),
              ElementsAre(StartsWith("info job ended job=j trace=t1 owner=ann state=partial seconds=90 ")));
  ExpectLine("jobs_ended_total{state=\"partial\"} 1");
  ExpectLine("jobs_ended_total{state=\"done\"} 0");
  ExpectLine("job_seconds_sum{state=\"partial\"} 90");
  ExpectLine("holes_filled_total 4");
  ExpectLine("cells_done_total 2");
  ExpectLine("triangles_total 300");
}

TEST_F(ClusterEventsTest, CountsJobsOfEarlierProcessesWithoutSayingSo) {
  const Job& job = NewJob("j");
  ASSERT_TRUE(state_.Apply(JobFinished{"j", JobState::kFailed, kStart + absl::Seconds(9)}).ok());
  events_.JobRemembered(job);
  EXPECT_TRUE(log_.lines().empty());
  ExpectLine("jobs_ended_total{state=\"failed\"} 1");
}

TEST_F(ClusterEventsTest, MeasuresHowLongAJobWaitedForItsFirstTask) {
  Job job = NewJob("j");
  job.started = kStart + absl::Seconds(7);
  events_.JobStarted(job, {});
  ExpectLine("job_queue_seconds_sum 7");
  EXPECT_THAT(log_.lines(), ElementsAre("info job started job=j queue_seconds=7\n"));
}

TEST_F(ClusterEventsTest, ShowsNoJobBeforeItKnowsAny) {
  ExpectLine("running_job_done_ratio{slot=\"1\"} Nan");
  ExpectLine("running_job_age_seconds{slot=\"16\"} Nan");
}

TEST_F(ClusterEventsTest, GivesEachRunningJobASlotForItsTime) {
  NewJob("a");
  NewJob("b");
  EXPECT_EQ(events_.SlotOf("a"), 0);
  events_.Show(state_, kStart + absl::Seconds(5));
  EXPECT_EQ(events_.SlotOf("a"), 1);
  EXPECT_EQ(events_.SlotOf("b"), 2);
  ExpectLine("running_job_done_ratio{slot=\"2\"} 0");
  ExpectLine("running_job_age_seconds{slot=\"1\"} 5");
  ASSERT_TRUE(state_.Apply(JobCancelled{"a", kStart}).ok());
  NewJob("c");
  events_.Show(state_, kStart + absl::Seconds(6));
  EXPECT_EQ(events_.SlotOf("a"), 0);
  EXPECT_EQ(events_.SlotOf("b"), 2);  // keeps it
  EXPECT_EQ(events_.SlotOf("c"), 1);
  ExpectLine("running_job_done_ratio{slot=\"3\"} Nan");
}

TEST_F(ClusterEventsTest, HasNoMoreSlotsThanItSays) {
  for (size_t i = 0; i < ClusterEvents::kSlots + 1; ++i) NewJob(absl::StrCat("job", i));
  events_.Show(state_, kStart);
  EXPECT_EQ(events_.SlotOf(absl::StrCat("job", ClusterEvents::kSlots)), 0);
}

TEST_F(ClusterEventsTest, CountsHolesOnceThoughAJobTellsThemAgain) {
  NewJob("j");
  for (const int64_t filled : {3, 1, 5}) {
    ASSERT_TRUE(state_.Apply(JobProgressed{"j", {"fill", 2, 0, 9, filled}}).ok());
    events_.Show(state_, kStart);
  }
  ExpectLine("holes_filled_total 5");
}

TEST_F(ClusterEventsTest, TellsOfWorkers) {
  const WorkerRecord worker{"w", 4, 0, false, kStart, {{"j", 1}}};
  events_.WorkerCame(worker, "0.1.0", "node7");
  events_.WorkerLost(worker, kStart + absl::Seconds(31));
  events_.WorkerLeft("v");
  events_.WorkerSuspected("u", "its result was wrong");
  events_.WorkerCleared("t");
  events_.WorkerSetAside("u", "its result was wrong");
  EXPECT_THAT(log_.lines(),
              ElementsAre("info worker came worker=w threads=4 worker_release=0.1.0 identity=node7\n",
                          "warning worker lost worker=w silent_seconds=31 tasks=1\n", "info worker left worker=v\n",
                          "warning worker suspected worker=u reason=\"its result was wrong\"\n",
                          "info worker cleared worker=t\n",
                          "error worker set aside worker=u reason=\"its result was wrong\"\n"));
  ExpectLine("workers_came_total 1");
  ExpectLine("workers_lost_total 1");
}

TEST_F(ClusterEventsTest, OneOfManyRefusedWorkersHasALine) {
  const absl::Status reason = absl::FailedPreconditionError("worker w speaks protocol 1");
  for (const int seconds : {0, 2, 9, 10}) {
    events_.WorkerRefused(absl::StrCat("w", seconds), "0.0.9", reason, kStart + absl::Seconds(seconds));
  }
  EXPECT_THAT(
      log_.lines(),
      ElementsAre("warning worker refused worker=w0 worker_release=0.0.9 reason=\"worker w speaks protocol 1\"\n",
                  "warning worker refused worker=w10 worker_release=0.0.9 reason=\"worker w speaks protocol 1\"\n"));
}

TEST_F(ClusterEventsTest, NamesTheTaskWhoseAttemptFailed) {
  Task task;
  task.id = 3;
  task.cell = {1, 2};
  task.stage = Stage::kFill;
  task.attempts = 2;
  events_.AttemptFailed(task, "j", "w", {"", "t1"}, absl::UnavailableError("disk\nfull"));
  EXPECT_THAT(log_.lines(), ElementsAre(HasSubstr("job=j trace=t1 task=3")));
  EXPECT_THAT(log_.lines().front(),
              HasSubstr("stage=fill attempt=2 worker=w code=UNAVAILABLE error=\"disk\\\\x0afull\""));
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
