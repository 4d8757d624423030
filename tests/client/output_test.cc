#include "client/output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_split.h"
#include "absl/time/clock.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

v1::Job LongJob() {
  v1::Job job;
  job.set_name("jobs/0123456789ab");
  job.set_state(v1::RUNNING);
  job.set_paused(true);
  job.mutable_progress()->set_cells(10000);
  job.mutable_progress()->set_cells_done(9999);
  job.mutable_progress()->set_tasks(50000);
  job.mutable_progress()->set_tasks_done(49999);
  job.mutable_create_time()->set_seconds(absl::ToUnixSeconds(absl::Now() - absl::Hours(76)));
  job.mutable_spec()->set_out("/mnt/shared/projects/2026/city-of-somewhere/tiles-filled");
  return job;
}

v1::WorkerInfo LongWorker() {
  v1::WorkerInfo worker;
  worker.set_id("tilemend-worker-6b7f8d9c4f-x7k2p-1-1d3964");
  worker.set_state(v1::WORKING);
  worker.set_threads(64);
  worker.set_tasks(64);
  worker.mutable_first_seen()->set_seconds(absl::ToUnixSeconds(absl::Now() - absl::Minutes(65)));
  worker.mutable_last_seen()->set_seconds(absl::ToUnixSeconds(absl::Now()) + 1);  // so that it is "0 s" ago for long
  worker.set_release("0.1.0");
  worker.set_identity("worker");
  return worker;
}

void ExpectLinesWithin(const std::string& text, size_t columns) {
  for (const absl::string_view line : absl::StrSplit(text, '\n')) {
    EXPECT_LE(ColumnsOf({line.data(), line.size()}), columns) << text;
  }
}

TEST(OutputTest, StatesAreInWordsOfPeople) {
  v1::WorkerInfo worker;
  worker.set_id("w");
  worker.set_state(v1::WORKING);
  EXPECT_THAT(WorkersText({worker}, OutputFormat::kTable), testing::HasSubstr("idle"));
  worker.set_tasks(1);
  EXPECT_THAT(WorkersText({worker}, OutputFormat::kTable), testing::HasSubstr("working"));
  worker.set_tasks(0);
  worker.set_state(v1::SET_ASIDE);
  EXPECT_THAT(WorkersText({worker}, OutputFormat::kTable), testing::HasSubstr("set aside"));
  v1::Job job;
  job.set_state(v1::RUNNING);
  EXPECT_THAT(JobText(job, OutputFormat::kTable), testing::HasSubstr("running"));
  job.set_waiting("no worker is connected");
  EXPECT_THAT(JobText(job, OutputFormat::kTable), testing::Not(testing::HasSubstr("running")));
  job.set_paused(true);
  EXPECT_THAT(JobText(job, OutputFormat::kTable), testing::HasSubstr("paused"));
  job.set_state(v1::CANCELLED);
  EXPECT_THAT(JobText(job, OutputFormat::kTable), testing::Not(testing::HasSubstr("paused")));
}

TEST(JobTextTest, BeginsWithTheNameThatTheJobHas) {
  v1::Job job;
  job.set_state(v1::DONE);
  EXPECT_THAT(JobText(job, OutputFormat::kTable), testing::StartsWith("state    done\nscene"));
  job.set_name("jobs/7");
  EXPECT_THAT(JobText(job, OutputFormat::kTable), testing::StartsWith("job      jobs/7\nstate    done\n"));
}

TEST(JobTextTest, ADryRunFillsNothingSoNothingIsLeftToDo) {
  v1::Job job;
  job.set_state(v1::DONE);
  job.mutable_spec()->set_dry_run(true);
  job.mutable_progress()->set_cells(4);
  job.mutable_progress()->set_holes(32);
  const std::string text = JobText(job, OutputFormat::kTable);
  EXPECT_THAT(text, HasSubstr("cells    4\nholes    32\n"));
  EXPECT_THAT(text, testing::Not(HasSubstr("\nout")));
  job.mutable_spec()->set_dry_run(false);
  EXPECT_THAT(JobText(job, OutputFormat::kTable), HasSubstr("holes    0/32\n"));
}

TEST(JobTextTest, LeavesOutWhatIsNotKnownYet) {
  v1::Job job;
  job.set_state(v1::RUNNING);
  const std::string begun = JobText(job, OutputFormat::kTable);
  for (const char* name : {"phase", "cells", "holes", "tasks"}) EXPECT_THAT(begun, Not(HasSubstr(name)));
  job.mutable_progress()->set_phase("survey");
  job.mutable_progress()->set_tasks(4);
  const std::string later = JobText(job, OutputFormat::kTable);
  EXPECT_THAT(later, HasSubstr("phase    look at the tiles\n"));
  EXPECT_THAT(later, HasSubstr("tasks    0/4\n"));
}

TEST(JobsTextTest, KeepsToEightyColumns) {
  const std::string text = JobsText({LongJob()}, OutputFormat::kTable, 80);
  ExpectLinesWithin(text, 80);
  for (const char* shown : {"jobs/0123456789ab", "  paused  ", "49999/50000", "3 d 04 h", "-filled"}) {
    EXPECT_THAT(text, HasSubstr(shown));
  }
  EXPECT_THAT(text, Not(HasSubstr("CELLS")));
  EXPECT_THAT(JobsText({LongJob()}, OutputFormat::kTable), HasSubstr(LongJob().spec().out()));
}

TEST(WorkersTextTest, KeepsToEightyColumns) {
  const std::string text = WorkersText({LongWorker()}, OutputFormat::kTable, 80);
  ExpectLinesWithin(text, 80);
  EXPECT_THAT(text, HasSubstr("k2p-1-1d3964  working  64/64  1 h 05 min  0 s"));
  EXPECT_THAT(WorkersText({LongWorker()}, OutputFormat::kTable), HasSubstr(LongWorker().id()));
}

TEST(WorkersTextTest, TellsTasksThatWaitFromThoseThatRun) {
  v1::WorkerInfo worker;
  worker.set_threads(2);
  worker.set_tasks(4);
  EXPECT_THAT(WorkersText({worker}, OutputFormat::kTable), HasSubstr("  2/2, 2 waiting  "));
  worker.set_tasks(1);
  EXPECT_THAT(WorkersText({worker}, OutputFormat::kTable), HasSubstr("  1/2  "));
  EXPECT_THAT(WorkersText({worker}, OutputFormat::kTable), Not(HasSubstr("waiting")));
}

TEST(CountedTest, OneHasItsOwnWords) {
  EXPECT_EQ(Counted(1, "edge"), "1 edge");
  EXPECT_EQ(Counted(0, "edge"), "0 edges");
  EXPECT_EQ(Counted(1, "fill of water", "fills of water"), "1 fill of water");
  EXPECT_EQ(Counted(2, "fill of water", "fills of water"), "2 fills of water");
}

TEST(DurationTextTest, HasTwoUnitsAtMost) {
  EXPECT_EQ(DurationText(absl::Seconds(-3)), "less than 1 s");
  EXPECT_EQ(DurationText(absl::Milliseconds(499)), "less than 1 s");
  EXPECT_EQ(DurationText(absl::Milliseconds(1190)), "1 s");
  EXPECT_EQ(DurationText(absl::Milliseconds(59600)), "1 min 00 s");
  EXPECT_EQ(DurationText(absl::Seconds(59)), "59 s");
  EXPECT_EQ(DurationText(absl::Seconds(125)), "2 min 05 s");
  EXPECT_EQ(DurationText(absl::Minutes(47 * 60 + 5)), "47 h 05 min");
  EXPECT_EQ(DurationText(absl::Hours(76)), "3 d 04 h");
}

}  // namespace
}  // namespace tilemend
