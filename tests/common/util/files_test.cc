#include "common/util/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> NamesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

class FilesTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
};

TEST_F(FilesTest, ReadsBackWhatWasWritten) {
  for (const std::string& content : {std::string(), std::string("a\0\r\n\xff", 5), std::string(3 << 20, 'x')}) {
    for (const Sync sync : {Sync::kYes, Sync::kNo}) {
      ASSERT_TRUE(WriteFileAtomically(folder_ / "file", content, sync).ok());
      EXPECT_EQ(ReadFile(folder_ / "file").value(), content);
    }
  }
  EXPECT_THAT(NamesIn(folder_.path()), ElementsAre("file")) << "nothing else is left behind";
}

TEST_F(FilesTest, MakesTheFoldersAbove) {
  ASSERT_TRUE(WriteFileAtomically(folder_ / "a/b/c", "x").ok());
  EXPECT_EQ(ReadFile(folder_ / "a/b/c").value(), "x");
}

TEST_F(FilesTest, ReadingNamesTheFileAndTheReason) {
  const auto status = [this](const std::string& name) { return ReadFile(folder_ / name).status(); };
  folder_.Write("file", "x");
  EXPECT_EQ(status("none").code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(status("none").message()), StartsWith(folder_ / "none: cannot open: "));
  EXPECT_EQ(status("file/below").code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(status(".").code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status(".").message()), HasSubstr("not a regular file"));
  EXPECT_EQ(status(std::string(5000, 'x')).code(), absl::StatusCode::kInvalidArgument);
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(status("pipe").code(), absl::StatusCode::kInvalidArgument) << "nobody writes to it: must not hang";
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_EQ(status("loop").code(), absl::StatusCode::kInvalidArgument);
}

TEST_F(FilesTest, WritingNamesTheFileAndLeavesNothing) {
  folder_.Write("file", "kept");
  fs::create_directory(folder_ / "folder");
  EXPECT_EQ(WriteFileAtomically(folder_ / "file/below", "x").code(), absl::StatusCode::kInvalidArgument);
  const absl::Status onto_folder = WriteFileAtomically(folder_ / "folder", "x");
  EXPECT_EQ(onto_folder.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(onto_folder.message()), StartsWith(folder_ / "folder: cannot rename into place: "));
  EXPECT_EQ(WriteFileAtomically(folder_ / std::string(5000, 'x'), "x").code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(ReadFile(folder_ / "file").value(), "kept");
  EXPECT_THAT(NamesIn(folder_.path()), testing::UnorderedElementsAre("file", "folder"));
  EXPECT_TRUE(fs::is_empty(folder_ / "folder"));
}

TEST_F(FilesTest, WritesNowhereThatItMayNot) {
  EXPECT_EQ(WriteFileAtomically("/proc/tilemend/x", "x").code(), absl::StatusCode::kPermissionDenied);
  if (::geteuid() == 0) return;  // may write anywhere
  fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(WriteFileAtomically(folder_ / "x", "x").code(), absl::StatusCode::kPermissionDenied);
  fs::permissions(folder_.path(), fs::perms::owner_all);
}

TEST_F(FilesTest, AReaderSeesAWholeFileWhileManyWrite) {
  const std::string path = folder_ / "file";
  ASSERT_TRUE(WriteFileAtomically(path, std::string(1000, 'a'), Sync::kNo).ok());
  std::vector<std::thread> writers;
  for (const char c : {'a', 'b', 'c', 'd'}) {
    writers.emplace_back([&path, c] {
      for (int i = 0; i < 100; ++i) EXPECT_TRUE(WriteFileAtomically(path, std::string(1000, c), Sync::kNo).ok());
    });
  }
  int whole = 0;
  for (int i = 0; i < 200; ++i) {
    const auto content = ReadFile(path);
    whole += content.ok() && content->size() == 1000 && *content == std::string(1000, content->front()) ? 1 : 0;
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(whole, 200);
  EXPECT_THAT(NamesIn(folder_.path()), ElementsAre("file"));
}

ino_t InodeOf(const std::string& path) {
  struct stat info {};
  EXPECT_EQ(::stat(path.c_str(), &info), 0) << path;
  return info.st_ino;
}

TEST_F(FilesTest, CarriesAFileOfAnySizeToANewFolder) {
  for (const std::string& content : {std::string(), std::string("a\0b", 3), std::string(70 << 20, 'x')}) {
    const std::string from = folder_.Write("from", content);
    for (const Carry how : {Carry::kCopy, Carry::kLink}) {
      ASSERT_TRUE(CarryFile(from, folder_ / "new/deep/to", how).ok());
      EXPECT_EQ(ReadFile(folder_ / "new/deep/to").value(), content);
      EXPECT_EQ(ReadFile(from).value(), content);
      EXPECT_THAT(NamesIn(folder_ / "new/deep"), ElementsAre("to"));
    }
  }
}

TEST_F(FilesTest, ACopyIsAFileOfItsOwnAndALinkIsTheSameFile) {
  const std::string from = folder_.Write("from", "original"), to = folder_ / "to";
  ASSERT_TRUE(CarryFile(from, to, Carry::kLink).ok());
  EXPECT_EQ(InodeOf(to), InodeOf(from));
  ASSERT_TRUE(CarryFile(from, to, Carry::kLink).ok()) << "again";
  ASSERT_TRUE(CarryFile(from, to, Carry::kCopy).ok()) << "in place of the link";
  EXPECT_NE(InodeOf(to), InodeOf(from));
  EXPECT_EQ(ReadFile(from).value(), "original");
  EXPECT_EQ(NamesIn(folder_.path()).size(), 2U) << "nothing else is left behind";
}

TEST_F(FilesTest, CarriesWhatALinkLeadsTo) {
  const std::string from = folder_.Write("real", "original");
  fs::create_symlink(from, folder_ / "link");
  for (const Carry how : {Carry::kCopy, Carry::kLink}) {
    ASSERT_TRUE(CarryFile(folder_ / "link", folder_ / "to", how).ok());
    EXPECT_FALSE(fs::is_symlink(folder_ / "to"));
    EXPECT_EQ(ReadFile(folder_ / "to").value(), "original");
  }
}

TEST_F(FilesTest, CarriesInPlaceOfALinkToTheFileItself) {
  const std::string from = folder_.Write("from", "original");
  for (const Carry how : {Carry::kCopy, Carry::kLink}) {
    fs::remove(folder_ / "to");
    fs::create_symlink(from, folder_ / "to");
    ASSERT_TRUE(CarryFile(from, folder_ / "to", how).ok());
    EXPECT_FALSE(fs::is_symlink(folder_ / "to"));
    EXPECT_EQ(ReadFile(folder_ / "to").value(), "original");
  }
}

TEST_F(FilesTest, CarryingLeavesAFileAloneThatItWouldWriteOverItself) {
  const std::string from = folder_.Write("from", "original");
  fs::create_directory_symlink(folder_.path(), folder_ / "again");
  EXPECT_EQ(CarryFile(from, folder_ / "again/from", Carry::kCopy).code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(CarryFile(folder_ / "none", folder_ / "to", Carry::kCopy).code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(CarryFile(folder_.path(), folder_ / "to", Carry::kLink).code(), absl::StatusCode::kInvalidArgument);
  EXPECT_FALSE(fs::exists(folder_ / "to"));
}

TEST_F(FilesTest, NewFilesNeedTheirFolderAndNoOtherFile) {
  ASSERT_TRUE(WriteNewFile(folder_ / "a", "x").ok());
  EXPECT_EQ(WriteNewFile(folder_ / "a", "y").code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(CarryToNewFile(folder_ / "a", folder_ / "a", Carry::kLink).status().code(),
            absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(ReadFile(folder_ / "a").value(), "x");
  EXPECT_EQ(CarryToNewFile(folder_ / "a", folder_ / "b", Carry::kCopy).value(), 1);
  EXPECT_EQ(CarryToNewFile(folder_ / "a", folder_ / "c", Carry::kLink).value(), 1);
  EXPECT_EQ(fs::hard_link_count(folder_ / "a"), 2U);
  EXPECT_FALSE(WriteNewFile(folder_ / "none/a", "x").ok());
  EXPECT_FALSE(CarryToNewFile(folder_ / "a", folder_ / "none/a", Carry::kLink).ok());
  EXPECT_FALSE(fs::exists(folder_ / "none"));
}

TEST_F(FilesTest, NewFilesOfAnySizeHoldWhatWasWritten) {
  constexpr size_t kMegabyte = size_t{1} << 20;
  for (const size_t size : {kMegabyte - 1, kMegabyte, 2 * kMegabyte + 1, 3 * kMegabyte + 4095, 3 * kMegabyte + 8192}) {
    std::string content(size, '\0');
    for (size_t i = 0; i < size; ++i) content[i] = static_cast<char>(i * 2654435761U >> 13);
    const std::string path = folder_ / std::to_string(size);
    ASSERT_TRUE(WriteNewFile(path, content).ok());
    EXPECT_TRUE(ReadFile(path).value() == content) << size << " bytes";
  }
}

TEST_F(FilesTest, MovesAFileInPlaceOfAnother) {
  folder_.Write("from", "new");
  folder_.Write("deep/to", "old");
  ASSERT_TRUE(MoveFile(folder_ / "from", folder_ / "deep/to").ok());
  EXPECT_EQ(ReadFile(folder_ / "deep/to").value(), "new");
  EXPECT_EQ(MoveFile(folder_ / "from", folder_ / "deep/to").code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(ReadFile(folder_ / "deep/to").value(), "new");
  fs::create_hard_link(folder_ / "deep/to", folder_ / "from");
  ASSERT_TRUE(MoveFile(folder_ / "from", folder_ / "deep/to").ok());
  EXPECT_FALSE(fs::exists(folder_ / "from")) << "two names of one file";
  EXPECT_TRUE(SyncFolder(folder_ / "deep").ok());
  EXPECT_FALSE(SyncFolder(folder_ / "none").ok());
}

}  // namespace
}  // namespace tilemend
