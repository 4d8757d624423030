#include "common/s3/local_copies.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace tilemend {
namespace {

class LocalCopiesTest : public testing::Test {
 protected:
  void Keep(LocalCopies& copies, const std::string& name, const std::string& text) {
    const auto file = copies.NewFile();
    ASSERT_TRUE(file.ok()) << file.status();
    ASSERT_EQ(::write(*file, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    copies.Keep(name, *file, static_cast<int64_t>(text.size()));
    ::close(*file);
  }
  std::string Text(LocalCopies& copies, const std::string& name) {
    const int file = copies.Find(name);
    if (file < 0) return "none";
    char text[64];
    const ssize_t size = ::pread(file, text, sizeof(text), 0);
    ::close(file);
    return {text, static_cast<size_t>(size)};
  }
};

TEST_F(LocalCopiesTest, FindsWhatItKeeps) {
  LocalCopies copies("", 100);
  Keep(copies, "a", "tile a");
  EXPECT_EQ(Text(copies, "a"), "tile a");
  EXPECT_EQ(Text(copies, "b"), "none");
}

TEST_F(LocalCopiesTest, DropsWhatWasNotUsedForTheLongestTime) {
  LocalCopies copies("", 10);
  Keep(copies, "a", "aaaa");
  Keep(copies, "b", "bbbb");
  EXPECT_EQ(Text(copies, "a"), "aaaa");
  Keep(copies, "c", "cccc");
  EXPECT_EQ(Text(copies, "b"), "none");
  EXPECT_EQ(Text(copies, "a"), "aaaa");
  EXPECT_EQ(Text(copies, "c"), "cccc");
}

TEST_F(LocalCopiesTest, KeepsNothingLargerThanItsBound) {
  LocalCopies copies("", 3);
  Keep(copies, "a", "aaaa");
  EXPECT_EQ(Text(copies, "a"), "none");
}

TEST_F(LocalCopiesTest, LeavesNoNameInItsFolder) {
  const std::string folder = testing::TempDir() + "/copies";
  std::filesystem::create_directories(folder);
  LocalCopies copies(folder, 100);
  Keep(copies, "a", "aaaa");
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace tilemend
