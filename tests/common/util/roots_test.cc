#include "common/util/roots.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <vector>

#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

// Below the test's folder, where root/ is the root; 42 ways out with those of WaysOut.
constexpr const char* kTailsOut[] = {"root/../secret/key",
                                     "root/a/../../secret/key",
                                     "root/a/b/../../../secret/key",
                                     "root/./../secret/key",
                                     "root//..//secret/key",
                                     "secret/key",
                                     "secret/deep/key",
                                     "root-other/key",
                                     "root/file",
                                     "root/absolute",
                                     "root/folder/key",
                                     "root/folder/deep/key",
                                     "root/absolute-folder/key",
                                     "root/up/secret/key",
                                     "root/a/upup/secret/key",
                                     "root/a/file",
                                     "root/chain",
                                     "root/w",
                                     "root/slash/etc/passwd",
                                     "root/magic/etc/passwd",
                                     "root/dangling",
                                     "root/through/key",
                                     "root/neighbour/key",
                                     "root/fd/0",
                                     "root/up/root/tile.ply",
                                     "root/up",
                                     "root/folder",
                                     "root/..",
                                     "root/a/../..",
                                     "rootx",
                                     "root-other",
                                     "root/folder/..",
                                     "root/folder/../secret",
                                     "root/a/upup"};

// root/ with links that lead out in every way, and secret/ beside it.
class RootsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* folder : {"root/a/b", "root-other", "secret/deep", "second"})
      fs::create_directories(folder_ / folder);
    for (const char* file : {"root/tile.ply", "root/a/b/tile.ply", "secret/key", "secret/deep/key", "root-other/key"}) {
      ASSERT_TRUE(WriteFileAtomically(folder_ / file, "private line").ok());
    }
    const std::vector<std::pair<std::string, std::string>> links = {{"../secret/key", "root/file"},
                                                                    {folder_ / "secret/key", "root/absolute"},
                                                                    {"../secret", "root/folder"},
                                                                    {folder_ / "secret", "root/absolute-folder"},
                                                                    {"..", "root/up"},
                                                                    {"../..", "root/a/upup"},
                                                                    {"../../secret/key", "root/a/file"},
                                                                    {"file", "root/chain"},
                                                                    {"a/b/../../../secret/key", "root/w"},
                                                                    {"/", "root/slash"},
                                                                    {"/proc/self/root", "root/magic"},
                                                                    {"../secret/not-there", "root/dangling"},
                                                                    {"up/secret", "root/through"},
                                                                    {"../root-other", "root/neighbour"},
                                                                    {"/dev/fd", "root/fd"},
                                                                    {"loop2", "root/loop1"},
                                                                    {"loop1", "root/loop2"}};
    for (const auto& [target, name] : links) fs::create_symlink(target, folder_ / name);
    fs::create_symlink("b/tile.ply", folder_ / "root/a/inside");
    auto roots = Roots::Open({folder_ / "root", folder_ / "second"});
    ASSERT_TRUE(roots.ok()) << roots.status();
    roots_ = *roots;
    KeepFilesTo(roots_);
  }
  void TearDown() override { KeepFilesTo(nullptr); }

  std::vector<std::string> WaysOut() {
    std::vector<std::string> ways;
    for (const char* tail : kTailsOut) ways.push_back(folder_ / tail);
    for (const char* path : {"/etc/passwd", "/", "/proc/self/environ", "", "tile.ply", "../root/tile.ply", "~/key",
                             "/proc/self/root/etc/passwd"}) {
      ways.emplace_back(path);
    }
    return ways;
  }

  TemporaryFolder folder_;
  std::shared_ptr<const Roots> roots_;
};

TEST_F(RootsTest, OpensWhatLiesBelow) {
  for (const char* file : {"root/tile.ply", "root/a/b/tile.ply", "root/a/inside", "root//a/./b/tile.ply"}) {
    EXPECT_TRUE(ReadFile(folder_ / file).ok()) << file;
    EXPECT_TRUE(roots_->Check(folder_ / file).ok()) << file;
  }
  EXPECT_TRUE(roots_->Check(folder_ / "root").ok());
  EXPECT_TRUE(roots_->Check(folder_ / "second/not/there/yet").ok());
}

TEST_F(RootsTest, LetsNoPathOut) {
  const std::vector<std::string> ways = WaysOut();
  EXPECT_GE(ways.size(), 40U);
  for (const std::string& path : ways) {
    EXPECT_EQ(ErrorReason(roots_->Check(path)), "OUTSIDE_ROOTS") << path;
    const int fd = roots_->OpenFile(path, O_RDONLY | O_CLOEXEC);
    EXPECT_LT(fd, 0) << path;
    const auto read = ReadFile(path);
    EXPECT_FALSE(read.ok()) << path;
    EXPECT_THAT(std::string(read.status().message()), Not(HasSubstr("private"))) << path;
  }
}

TEST_F(RootsTest, WritesNothingOutside) {
  for (const std::string& path : WaysOut()) {
    if (path == folder_ / "root/file" || path == folder_ / "root/absolute" || path == folder_ / "root/a/file" ||
        path == folder_ / "root/chain" || path == folder_ / "root/w" || path == folder_ / "root/dangling" ||
        path == folder_ / "root/up" || path == folder_ / "root/folder" || path == folder_ / "root/a/upup") {
      continue;  // a link itself may be replaced: it lies below
    }
    EXPECT_FALSE(WriteFileAtomically(path, "x").ok()) << path;
    EXPECT_FALSE(WriteFileAtomically(path + "/new/file", "x").ok()) << path;
    EXPECT_FALSE(WriteNewFile(path, "x").ok()) << path;
    EXPECT_FALSE(CarryFile(folder_ / "root/tile.ply", path, Carry::kLink).ok()) << path;
    EXPECT_FALSE(CarryFile(path, folder_ / "root/carried", Carry::kLink).ok()) << path;
    EXPECT_FALSE(MoveFile(folder_ / "root/a/b/tile.ply", path).ok()) << path;
  }
  KeepFilesTo(nullptr);
  EXPECT_EQ(ReadFile(folder_ / "secret/key").value(), "private line");
  EXPECT_TRUE(ReadFile(folder_ / "root/a/b/tile.ply").ok());
  EXPECT_FALSE(fs::exists(folder_ / "secret/new"));
}

TEST_F(RootsTest, SeesAndListsNothingOutside) {
  for (const std::string& path : WaysOut()) {
    EXPECT_EQ(KindOf(path), PathKind::kNothing) << path;
    EXPECT_FALSE(ListFolder(path).ok()) << path;
    EXPECT_FALSE(LookAt(path + "/key").ok()) << path;
    EXPECT_FALSE(CanWriteIn(path)) << path;
    EXPECT_FALSE(MakeFolder(path + "/new").ok()) << path;
    RemoveFile(path + "/key").IgnoreError();
    RemoveTree(path + "/deep").IgnoreError();
    RemoveEmptyFolder(path + "/deep").IgnoreError();
  }
  EXPECT_EQ(KindOf(folder_ / "root/a/inside"), PathKind::kFile);
  EXPECT_TRUE(ListFolder(folder_ / "root/a/b").ok());
  KeepFilesTo(nullptr);
  for (const char* file : {"secret/key", "secret/deep/key", "root-other/key"}) {
    EXPECT_EQ(KindOf(folder_ / file), PathKind::kFile) << file;
  }
  EXPECT_EQ(KindOf(folder_ / "secret/new"), PathKind::kNothing);
}

TEST_F(RootsTest, RemovesLinksAndNotWhatTheyLeadTo) {
  for (const char* link : {"root/folder", "root/up", "root/absolute-folder", "root/file"}) {
    EXPECT_TRUE(RemoveTree(folder_ / link).ok()) << link;
  }
  EXPECT_TRUE(RemoveTree(folder_ / "root/a").ok());
  KeepFilesTo(nullptr);
  EXPECT_EQ(KindOf(folder_ / "secret/deep/key"), PathKind::kFile);
  EXPECT_EQ(KindOf(folder_ / "root-other/key"), PathKind::kFile);
}

TEST_F(RootsTest, WritesBelow) {
  ASSERT_TRUE(WriteFileAtomically(folder_ / "second/x/y/file", "new").ok());
  EXPECT_EQ(ReadFile(folder_ / "second/x/y/file").value(), "new");
  ASSERT_TRUE(CarryFile(folder_ / "root/tile.ply", folder_ / "second/z/link", Carry::kLink).ok());
  EXPECT_EQ(fs::hard_link_count(folder_ / "second/z/link"), 2U);
  ASSERT_TRUE(MoveFile(folder_ / "second/x/y/file", folder_ / "root/moved").ok());
  EXPECT_EQ(ReadFile(folder_ / "root/moved").value(), "new");
  EXPECT_TRUE(absl::IsNotFound(MoveFile(folder_ / "second/none/file", folder_ / "root/moved"))) << "with its folder";
  EXPECT_TRUE(SyncFolder(folder_ / "root").ok());
}

TEST_F(RootsTest, KeepsToTheFolderThatItOpened) {
  fs::rename(folder_ / "root", folder_ / "old");
  fs::create_directory_symlink("secret", folder_ / "root");
  EXPECT_FALSE(ReadFile(folder_ / "root/key").ok());
  EXPECT_TRUE(ReadFile(folder_ / "root/tile.ply").ok());
}

TEST(RootsOpenTest, NeedsFoldersByAbsolutePath) {
  EXPECT_TRUE(absl::IsInvalidArgument(Roots::Open({"data"}).status()));
  EXPECT_TRUE(absl::IsNotFound(Roots::Open({"/not/there"}).status()));
}

}  // namespace
}  // namespace tilemend
