#include "worker/service/look_at_folders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "common/store/fingerprint.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

TEST(LookAtFoldersTest, TellsWhatItSeesAndWhetherItCanWrite) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "attempts");
  v1::JobFolders folders;
  folders.set_job("j");
  folders.add_files(folder.Write("scene.json", "{}"));
  folders.add_files(folder / "none");
  folders.set_attempts(folder / "attempts");
  v1::FoldersSeen seen = LookAtFolders(folders);
  EXPECT_EQ(seen.job(), "j");
  EXPECT_FALSE(seen.looking());
  ASSERT_EQ(seen.files_size(), 2);
  EXPECT_EQ(seen.files(0).fingerprint(), FingerprintOf(folder / "scene.json").value());
  EXPECT_THAT(seen.files(1).error(), testing::HasSubstr(folder / "none"));
  EXPECT_EQ(seen.write_error(), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder / "attempts"));
  folders.set_attempts(folder / "none");
  EXPECT_THAT(LookAtFolders(folders).write_error(), testing::HasSubstr(folder / "none"));
  folders.clear_attempts();
  EXPECT_EQ(LookAtFolders(folders).write_error(), "") << "a dry run writes nothing";
}

}  // namespace
}  // namespace tilemend
