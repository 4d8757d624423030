#include "common/util/folders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class FoldersTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.Write("a/file", "12345");
    folder_.Write("a/b/c", "");
    fs::create_symlink("a/file", folder_ / "link");
    fs::create_symlink("nowhere", folder_ / "broken");
  }
  TemporaryFolder folder_;
};

TEST_F(FoldersTest, TellsWhatIsThere) {
  EXPECT_EQ(LookAt(folder_ / "a/file")->kind, PathKind::kFile);
  EXPECT_EQ(LookAt(folder_ / "a/file")->size, 5);
  EXPECT_EQ(LookAt(folder_ / "a")->kind, PathKind::kFolder);
  EXPECT_EQ(LookAt(folder_ / "link")->size, 5);
  EXPECT_EQ(LookAt(folder_ / "link", Links::kKeep)->kind, PathKind::kOther);
  EXPECT_EQ(LookAt("/dev/null")->kind, PathKind::kOther);
  EXPECT_EQ(LookAt(folder_ / "broken", Links::kKeep)->kind, PathKind::kOther);
  for (const char* missing : {"broken", "x", "a/file/x"}) {
    const absl::Status status = LookAt(folder_ / missing).status();
    EXPECT_TRUE(absl::IsNotFound(status)) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr(missing));
    EXPECT_EQ(KindOf(folder_ / missing), PathKind::kNothing);
    EXPECT_EQ(*FindKind(folder_ / missing), PathKind::kNothing);
  }
}

TEST_F(FoldersTest, WhatCannotBeLookedAtIsNotNothing) {
  const std::string too_long = folder_ / std::string(300, 'x');
  EXPECT_TRUE(absl::IsInvalidArgument(FindKind(too_long).status()));
  EXPECT_EQ(KindOf(too_long), PathKind::kNothing);
}

TEST_F(FoldersTest, ListsNamesInOrder) {
  EXPECT_THAT(*ListFolder(folder_.path()), ElementsAre("a", "broken", "link"));
  EXPECT_TRUE(absl::IsNotFound(ListFolder(folder_ / "x").status()));
  EXPECT_FALSE(ListFolder(folder_ / "a/file").ok());
}

TEST_F(FoldersTest, MakesOneFolder) {
  EXPECT_TRUE(MakeFolder(folder_ / "new").ok());
  EXPECT_TRUE(MakeFolder(folder_ / "new").ok());
  EXPECT_EQ(KindOf(folder_ / "new"), PathKind::kFolder);
  EXPECT_TRUE(CanWriteIn(folder_ / "new"));
  EXPECT_FALSE(CanWriteIn(folder_ / "x"));
  EXPECT_TRUE(absl::IsPermissionDenied(MakeFolder(folder_ / "x/y")));
  EXPECT_TRUE(absl::IsInvalidArgument(MakeFolder(folder_ / "a/file/y")));
  EXPECT_TRUE(absl::IsInvalidArgument(MakeFolder(folder_ / "a/file")));
}

TEST_F(FoldersTest, RemovesWhatIsNamedAndNotWhatALinkLeadsTo) {
  EXPECT_TRUE(RemoveFile(folder_ / "link").ok());
  EXPECT_TRUE(RemoveFile(folder_ / "link").ok());
  EXPECT_EQ(KindOf(folder_ / "a/file"), PathKind::kFile);
  EXPECT_FALSE(RemoveFile(folder_ / "a").ok());
  EXPECT_FALSE(RemoveEmptyFolder(folder_ / "a").ok());
  fs::create_directory_symlink("../../a", folder_ / "a/b/up");
  EXPECT_TRUE(RemoveTree(folder_ / "a/b").ok());
  EXPECT_TRUE(RemoveTree(folder_ / "a/b").ok());
  EXPECT_THAT(*ListFolder(folder_ / "a"), ElementsAre("file"));
  EXPECT_TRUE(RemoveTree(folder_ / "broken").ok());
  EXPECT_TRUE(RemoveTree(folder_ / "a").ok());
  EXPECT_THAT(*ListFolder(folder_.path()), ElementsAre());
}

}  // namespace
}  // namespace tilemend
