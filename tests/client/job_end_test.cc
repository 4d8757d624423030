#include "client/job_end.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(CheckLineTest, IsACommandForAShell) {
  EXPECT_EQ(CheckLine("scene", "/data/out"), "check: tilemend check scene /data/out\n");
  EXPECT_EQ(CheckLine("my scene", "out"), "check: tilemend check 'my scene' out\n");
  EXPECT_EQ(CheckLine("it's $HOME", ""), "check: tilemend check 'it'\\''s $HOME' ''\n");
}

// In `out`, from 100 to 200 seconds after 1970 began.
v1::Job EndedIn(const std::string& out) {
  v1::Job job;
  job.set_state(v1::PARTIAL);
  job.mutable_spec()->set_scene("/data/scene");
  job.mutable_spec()->set_out(out);
  job.mutable_create_time()->set_seconds(100);
  job.mutable_end_time()->set_seconds(200);
  job.set_report(out + "/report.json");
  return job;
}

TEST(ClusterEndTextTest, HasTheWarningsOfTheReportAndWhatToDoNext) {
  TemporaryFolder folder;
  folder.Write("out/report.json", R"({"date": "1970-01-01T00:03:20Z", "cells": 4, "warnings": ["mind the gap"]})");
  const std::string out = folder / "out", text = ClusterEndText(EndedIn(out));
  EXPECT_THAT(text, StartsWith("\n1 warning\n  mind the gap\n"));
  EXPECT_THAT(text, HasSubstr("\npage: tilemend report " + out + " --html"));
  EXPECT_THAT(text, EndsWith("\ncheck: tilemend check /data/scene " + out + "\n"));
  v1::Job delivered = EndedIn(out);
  delivered.mutable_spec()->set_output_format("obj");
  EXPECT_THAT(ClusterEndText(delivered), HasSubstr("\ncheck: tilemend check "));
}

TEST(ClusterEndTextTest, SaysWhereTheReportCanBeSeenIfNotHere) {
  TemporaryFolder folder;
  const std::string out = folder / "none", text = ClusterEndText(EndedIn(out));
  EXPECT_THAT(text, StartsWith("\nwarnings and what is left: in the report, which this machine cannot read"));
  EXPECT_THAT(text, EndsWith("\nwhere it can be read: tilemend report " + out + "\n"));
  folder.Write("none/report.json", "[");
  EXPECT_THAT(ClusterEndText(EndedIn(out)), HasSubstr("not a report"));
}

TEST(ClusterEndTextTest, TakesNoReportOfALaterJobForItsOwn) {
  TemporaryFolder folder;
  folder.Write("out/report.json", R"({"date": "1970-01-01T00:03:21Z", "cells": 4, "warnings": ["mind the gap"]})");
  const std::string text = ClusterEndText(EndedIn(folder / "out"));
  EXPECT_THAT(text, HasSubstr("of another job"));
  EXPECT_THAT(text, Not(HasSubstr("mind the gap")));
}

TEST(ClusterEndTextTest, IsEmptyWithoutAReport) { EXPECT_EQ(ClusterEndText(v1::Job()), ""); }

}  // namespace
}  // namespace tilemend
