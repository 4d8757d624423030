#include "coordinator/jobs/job_proto.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/time/time.h"
#include "common/rpc/status_proto.h"

namespace tilemend {
namespace {

TEST(JobProtoTest, ASpecComesBackAsItWas) {
  JobSpec spec;
  spec.scene = "/scene";
  spec.out = "/out";
  spec.surface = "wang";
  spec.uniform = spec.overwrite = spec.dry_run = true;
  spec.gradation = 2.5;
  spec.size_limit = 99;
  spec.tension = 0;
  spec.seam_smoothing = 0;
  spec.seam_points = "spaced";
  spec.closure = "line";
  spec.water = "/water.geojson";
  spec.area = "/area.gpkg";
  spec.cells = "3,4";
  spec.water_profile = "usgs";
  EXPECT_EQ(SpecFromProto(SpecToProto(spec)), spec);
  EXPECT_EQ(SpecFromProto(SpecToProto(JobSpec())), JobSpec());
}

TEST(JobProtoTest, FieldsThatAreNotSetHaveTheDefaults) { EXPECT_EQ(SpecFromProto(v1::JobSpec()), JobSpec()); }

// As journals of earlier releases have it.
TEST(JobProtoTest, TheToleranceOfWaterIsReadOver) {
  const std::string field("\x61\x9a\x99\x99\x99\x99\x99\xc9\x3f", 9);  // 12, a double: 0.2
  JobSpec spec;
  spec.scene = "/scene";
  v1::JobSpec read;
  ASSERT_TRUE(read.ParseFromString(SpecToProto(spec).SerializeAsString() + field));
  EXPECT_EQ(SpecFromProto(read), spec);
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
  EXPECT_EQ(proto.progress().tasks_retried(), 1);
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
