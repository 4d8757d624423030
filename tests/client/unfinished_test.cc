#include "client/unfinished.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST(Unfinished, WhereThereIsAMarkerAndNoReport) {
  TemporaryFolder folder;
  EXPECT_FALSE(IsUnfinished(folder / "none"));
  EXPECT_FALSE(IsUnfinished(folder.path()));
  folder.Write("out/.tilemend-job", "");
  EXPECT_TRUE(IsUnfinished(folder / "out"));
  folder.Write("out/report.json", "{}");
  EXPECT_FALSE(IsUnfinished(folder / "out"));
}

TEST(Unfinished, WhereTheReportWasTakenAway) {
  TemporaryFolder folder;
  folder.Write("out/.tilemend-results", "");
  EXPECT_TRUE(IsOutput(folder / "out"));
  EXPECT_TRUE(IsUnfinished(folder / "out"));
  folder.Write("out/report.json", "{}");
  EXPECT_FALSE(IsUnfinished(folder / "out"));
  EXPECT_FALSE(IsOutput(folder.path()));
}

TEST(Unfinished, SaysWhatToDo) {
  TemporaryFolder folder;
  EXPECT_TRUE(CheckFinished(folder.path()).ok());
  folder.Write("out/.tilemend-job", "");
  const absl::Status status = CheckFinished(folder / "out");
  EXPECT_TRUE(absl::IsNotFound(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr("Run the same job again"));
}

TEST(CheckHasReport, SaysWhatIsMissing) {
  TemporaryFolder folder;
  const std::string out = folder / "out", scene = folder / "scene";
  EXPECT_EQ(CheckHasReport(out).message(), out + ": no such folder");
  folder.Write("scene/a.ply", "");
  EXPECT_EQ(CheckHasReport(scene + "/a.ply").message(), scene + "/a.ply: not a folder");
  EXPECT_EQ(CheckHasReport(scene).message(), scene + ": no output of `tilemend run` (it has no report.json)");
  folder.Write("out/.tilemend-results", "");
  EXPECT_THAT(std::string(CheckHasReport(out).message()), HasSubstr("is not complete"));
  folder.Write("out/report.json", "{}");
  EXPECT_TRUE(CheckHasReport(out).ok());
  EXPECT_TRUE(CheckHasReport("s3://bucket/out").ok());
}

TEST(CheckHasReport, TellsThatSceneAndOutputAreSwapped) {
  TemporaryFolder folder;
  const std::string out = folder / "out", scene = folder / "scene";
  folder.Write("scene/a.ply", "");
  folder.Write("out/report.json", "{}");
  EXPECT_EQ(CheckHasReport(scene, out).message(), scene + ": no output of `tilemend run` (it has no report.json); " +
                                                      out + " is one: give the scene first, then its output");
  EXPECT_TRUE(CheckHasReport(out, scene).ok());
}

}  // namespace
}  // namespace tilemend
