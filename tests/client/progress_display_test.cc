#include "client/progress_display.h"

#include <gtest/gtest.h>

#include <string>

#include "common/util/text.h"

namespace tilemend {
namespace {

TEST(BarLineTest, ShowsTheShareAndTheText) {
  EXPECT_EQ(BarLine(0, "survey", 0), "[..............................] survey");
  EXPECT_EQ(BarLine(0.5, "fill, 3/6 tasks", 200), "[###############...............] fill, 3/6 tasks");
  EXPECT_EQ(BarLine(1, "", 200), "[##############################] ");
}

TEST(BarLineTest, NeverReachesTheLastColumn) {
  const std::string text =
      "sample clusters and fill, 52/99 tasks, waits: Z\xc3\xbcrich \xe8\xa5\xbf\xe6\xb9\x96 is not mounted";
  for (size_t columns = 14; columns < 120; ++columns) {
    EXPECT_LT(ColumnsOf(BarLine(0.3, text, columns)), columns) << columns;
  }
}

TEST(BarLineTest, TheBarGetsShorterBeforeTheTextIsCut) {
  EXPECT_EQ(BarLine(0.5, "survey", 30), "[##########..........] survey");
  EXPECT_EQ(BarLine(0.5, "survey", 18), "[#####.....] surv");
}

TEST(TimesTextTest, GuessesTheRestOfAJobThatRuns) {
  v1::Job job;
  job.mutable_create_time()->set_seconds(1000);
  const absl::Time now = absl::FromUnixSeconds(1088);
  EXPECT_EQ(TimesText(job, 0.01, now), ", 1 min 28 s");
  EXPECT_EQ(TimesText(job, 0.5, now), ", 1 min 28 s, 1 min 28 s left");
  job.mutable_start_time()->set_seconds(1078);  // no task was done in the queue before
  EXPECT_EQ(TimesText(job, 0.5, now), ", 1 min 28 s, 10 s left");
  job.mutable_end_time()->set_seconds(1064);
  EXPECT_EQ(TimesText(job, 1, now), ", 1 min 04 s");
}

TEST(ProgressTextTest, LeavesOutWhatIsNotKnownYet) {
  v1::Job job;
  job.mutable_create_time()->set_seconds(1000);
  const absl::Time now = absl::FromUnixSeconds(1000);
  EXPECT_EQ(ProgressText(job, 0, now), "prepare, less than 1 s");
  job.mutable_progress()->set_phase("survey");
  job.mutable_progress()->set_cells(9);
  EXPECT_EQ(ProgressText(job, 0, now), "look at the tiles, 0/9 cells, less than 1 s");
  job.mutable_progress()->set_tasks(24);
  job.mutable_progress()->set_tasks_done(3);
  job.set_waiting("no worker is connected");
  EXPECT_EQ(ProgressText(job, 0, now), "look at the tiles, 3/24 tasks, 0/9 cells, waits: no worker is connected");
}

TEST(StepTextTest, SaysWhatIsCounted) {
  EXPECT_EQ(StepText("look at the tiles", 3, 24, "tile", absl::Seconds(12)), "look at the tiles, 3/24 tiles, 12 s");
  EXPECT_EQ(StepText("read", 0, 0, "hole", absl::Seconds(12)), "read, 12 s");
}

}  // namespace
}  // namespace tilemend
