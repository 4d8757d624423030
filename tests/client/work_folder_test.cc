#include "client/work_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "common/util/files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

TEST(WorkFolderTest, IsThereUntilItsEnd) {
  const TemporaryFolder folder;
  fs::path path;
  {
    const auto work = WorkFolder::Make(folder / "made/here");
    ASSERT_TRUE(work.ok()) << work.status();
    path = work->path();
    EXPECT_EQ(path.parent_path(), folder / "made/here");
    EXPECT_TRUE(WriteFileAtomically(path / "jobs/one/blob", "bytes").ok());
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(WorkFolderTest, TakesAwayWhatAnEndedProcessHasLeft) {
  const TemporaryFolder folder;
  folder.Write("tilemend-run-abcdef/jobs/one/blob", "left");
  folder.Write("tilemend-run-abcdef/.tilemend-work-folder", "");
  folder.Write("tilemend-run-berlin/report.json", "an output of a user's");
  folder.Write("tilemend-new-abcdef/blob", "just being made");
  folder.Write("tilemend-run-file", "no folder");
  folder.Write("mine/blob", "another's");
  fs::create_directory_symlink(folder / "mine", folder / "tilemend-run-link");
  ASSERT_TRUE(WorkFolder::Make(folder.path()).ok());
  EXPECT_FALSE(fs::exists(folder / "tilemend-run-abcdef"));
  for (const char* kept : {"tilemend-run-berlin/report.json", "tilemend-new-abcdef/blob", "tilemend-run-file",
                           "mine/blob", "tilemend-run-link"}) {
    EXPECT_TRUE(fs::exists(folder / kept)) << kept;
  }
}

TEST(WorkFolderTest, LeavesThoseOfProcessesThatRun) {
  const TemporaryFolder folder;
  const auto first = WorkFolder::Make(folder.path());
  ASSERT_TRUE(first.ok());
  const auto second = WorkFolder::Make(folder.path());
  ASSERT_TRUE(second.ok());
  EXPECT_NE(first->path(), second->path());
  EXPECT_TRUE(fs::exists(first->path()));
}

TEST(WorkFolderTest, NeedsAPlaceToWrite) {
  const TemporaryFolder folder;
  const auto work = WorkFolder::Make(folder.Write("file", "x"));
  EXPECT_EQ(work.status().code(), absl::StatusCode::kPermissionDenied);
}

TEST(WorkFolderTest, NamesATemporaryFolderThatIsNotThere) {
  const char* const set = std::getenv("TMPDIR");
  const std::optional<std::string> before = set == nullptr ? std::nullopt : std::optional<std::string>(set);
  ::setenv("TMPDIR", "/no/such/folder", 1);
  const absl::Status status = WorkFolder::Make("").status();
  before ? ::setenv("TMPDIR", before->c_str(), 1) : ::unsetenv("TMPDIR");
  EXPECT_EQ(status.code(), absl::StatusCode::kPermissionDenied);
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("TMPDIR=/no/such/folder: not a folder"));
}

}  // namespace
}  // namespace tilemend
