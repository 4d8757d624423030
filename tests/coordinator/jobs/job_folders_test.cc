#include "coordinator/jobs/job_folders.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

TEST(TryFoldersTest, SeesFilesAndWritesAmongAttempts) {
  const TemporaryFolder folder;
  const JobFolders folders{{{folder.Write("scene.json", "{}"), "of before"}}, folder.path()};
  EXPECT_TRUE(TryFolders(folders).ok()) << TryFolders(folders);
  EXPECT_FALSE(std::filesystem::exists(folder / "probe"));
  EXPECT_TRUE(TryFolders({}).ok());
}

TEST(TryFoldersTest, SaysWhatIsGone) {
  const TemporaryFolder folder;
  const absl::Status status = TryFolders({{{folder / "scene.json", ""}}, folder.path()});
  EXPECT_TRUE(absl::IsAborted(status)) << status;
  EXPECT_NE(status.message().find("scene.json"), std::string::npos) << status;
}

TEST(TryFoldersTest, SaysWhyItCannotWrite) {
  const absl::Status status = TryFolders({{}, "/proc/self"});
  EXPECT_NE(status.message().find("/proc/self"), std::string::npos) << status;
}

}  // namespace
}  // namespace tilemend
