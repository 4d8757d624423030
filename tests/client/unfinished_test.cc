#include "client/unfinished.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

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

TEST(CheckIsOutput, AsksWhetherTheFoldersAreSwapped) {
  TemporaryFolder folder;
  folder.Write("scene/scene.json", "{}");
  folder.Write("out/report.json", "{}");
  EXPECT_TRUE(CheckIsOutput(folder / "scene", folder / "out").ok());
  const absl::Status swapped = CheckIsOutput(folder / "out", folder / "scene");
  EXPECT_TRUE(absl::IsNotFound(swapped));
  EXPECT_THAT(std::string(swapped.message()), HasSubstr("has no report.json; are SCENE and OUT swapped?"));
  EXPECT_THAT(std::string(CheckIsOutput(folder / "scene", folder / "scene").message()), Not(HasSubstr("swapped")));
}

}  // namespace
}  // namespace tilemend
