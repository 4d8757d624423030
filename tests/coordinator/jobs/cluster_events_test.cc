#include "coordinator/jobs/cluster_events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/known_jobs.h"
#include "tests/support/list_log.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ClusterEventsTest : public KnownJobsTest {
 protected:
  ListLog log_;
  JobMetrics jobs_{registry_};
  ClusterEvents events_{registry_, jobs_, log_};
};

TEST_F(ClusterEventsTest, SaysAndCountsHowAJobEnded) {
  const Job& job = NewJob("j");
  ASSERT_TRUE(state_.Apply(JobProgressed{"j", {"assemble", 2, 2, 5, 4, 300}}).ok());
  ASSERT_TRUE(state_.Apply(JobFinished{"j", JobState::kPartial, start_ + absl::Seconds(90)}).ok());
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

TEST_F(ClusterEventsTest, MeasuresHowLongAJobWaitedForItsFirstTask) {
  Job job = NewJob("j");
  job.started = start_ + absl::Seconds(7);
  events_.JobStarted(job, {});
  ExpectLine("job_queue_seconds_sum 7");
  EXPECT_THAT(log_.lines(), ElementsAre("info job started job=j queue_seconds=7\n"));
}

TEST_F(ClusterEventsTest, TellsOfWorkers) {
  const WorkerRecord worker{"w", 4, 0, false, start_, {{"j", 1}}};
  events_.WorkerCame(worker, "0.1.0", "node7");
  events_.WorkerLost(worker, start_ + absl::Seconds(31));
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
    events_.WorkerRefused(absl::StrCat("w", seconds), "0.0.9", reason, start_ + absl::Seconds(seconds));
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

}  // namespace
}  // namespace tilemend
