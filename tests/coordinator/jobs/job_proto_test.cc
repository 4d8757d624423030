#include "coordinator/jobs/job_proto.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/time/time.h"
#include "common/options/job_options.h"
#include "common/rpc/status_proto.h"

namespace tilemend {
namespace {

TEST(JobProtoTest, ASpecComesBackWithItsDefaults) {
  JobSpec spec;
  spec.set_scene("/scene");
  spec.set_gradation(2.5);
  spec.set_tension(0);
  const JobSpec back = JobFromProto(JobToProto({}, spec, {}, absl::OkStatus())).spec;
  EXPECT_TRUE(AreEqual(back, WithDefaults(spec)));
  EXPECT_TRUE(back.has_tension());
}

TEST(JobProtoTest, TellsOfARunningJob) {
  Job job;
  job.id = "7";
  job.state = JobState::kRunning;
  job.version = 12;
  job.created = absl::FromUnixNanos(1'500'000'000'000'000'123);
  job.progress = {"fill", 10, 3, 20, 6, 700};
  job.counts.added = 9;
  job.counts.leased = 2;
  job.counts.retried = 1;
  job.counts.doubled = 2;
  job.counts.committed = 3;
  job.counts.failed = 1;
  job.counts.quarantined = 1;
  const v1::Job proto = JobToProto(job, {}, {}, absl::OkStatus());
  EXPECT_EQ(proto.name(), "jobs/7");
  EXPECT_EQ(proto.state(), v1::RUNNING);
  EXPECT_EQ(proto.cursor(), 12U);
  EXPECT_EQ(proto.create_time().seconds(), 1'500'000'000);
  EXPECT_EQ(proto.create_time().nanos(), 123);
  EXPECT_FALSE(proto.has_end_time());
  EXPECT_FALSE(proto.has_error());
  EXPECT_EQ(proto.progress().phase(), "fill");
  EXPECT_EQ(proto.progress().cells_done(), 3);
  EXPECT_EQ(proto.progress().holes_filled(), 6);
  EXPECT_EQ(proto.progress().triangles(), 700);
  EXPECT_EQ(proto.progress().tasks(), 9);
  EXPECT_EQ(proto.progress().tasks_done(), 5);
  EXPECT_EQ(proto.progress().tasks_running(), 2);
  EXPECT_EQ(proto.progress().tasks_retried(), 3);
  EXPECT_EQ(proto.progress().tasks_quarantined(), 1);
}

TEST(JobProtoTest, TellsHowAJobEnded) {
  Job job;
  job.ended = absl::FromUnixSeconds(99);
  job.warnings = {"a worker"};
  for (const auto& [state, expected] : {std::pair(JobState::kDone, v1::DONE),
                                        {JobState::kPartial, v1::PARTIAL},
                                        {JobState::kFailed, v1::FAILED},
                                        {JobState::kCancelled, v1::CANCELLED}}) {
    job.state = state;
    const JobOutcome outcome{true, "3 of 4", "/out/report.json", {"the area"}};
    const v1::Job proto = JobToProto(job, {}, outcome, absl::NotFoundError("gone"));
    EXPECT_THAT(proto.warnings(), testing::ElementsAre("a worker", "the area"));
    EXPECT_THAT(JobFromProto(proto).job.warnings, testing::ElementsAre("a worker", "the area"));
    EXPECT_EQ(proto.state(), expected);
    EXPECT_EQ(proto.end_time().seconds(), 99);
    EXPECT_EQ(proto.message(), "3 of 4");
    EXPECT_EQ(proto.report(), "/out/report.json");
    EXPECT_EQ(StatusFromProto(proto.error()), absl::NotFoundError("gone"));
  }
}

}  // namespace
}  // namespace tilemend
