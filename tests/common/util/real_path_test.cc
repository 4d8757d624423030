#include "common/util/real_path.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

class RealPathTest : public ::testing::Test {
 protected:
  RealPathTest() {
    folder_.Write("a/file", "x");
    fs::create_directory_symlink("a", folder_ / "to-a");
    fs::create_symlink("a/file", folder_ / "link");
    fs::create_symlink("loop", folder_ / "loop");
  }
  TemporaryFolder folder_;
  const fs::path root_ = fs::canonical(folder_.path());
};

TEST_F(RealPathTest, FollowsLinksAsFarAsThePathIsThere) {
  EXPECT_EQ(RealPath(folder_ / "link"), root_ / "a/file");
  EXPECT_EQ(RealPath(folder_ / "to-a/none/deep"), root_ / "a/none/deep");
  EXPECT_EQ(RealPath(folder_ / "x/../loop"), folder_ / "loop") << "leads nowhere";
}

TEST_F(RealPathTest, APlaceIsThatOfTheNameItself) {
  EXPECT_EQ(RealPlace(folder_ / "link"), root_ / "link");
  EXPECT_EQ(RealPlace(folder_ / "to-a/file"), root_ / "a/file");
  EXPECT_EQ(RealPlace("none"), fs::current_path() / "none");
}

TEST_F(RealPathTest, ALinkIsReplacedItself) {
  EXPECT_TRUE(TakesThePlaceOf(folder_ / "a/file", folder_ / "to-a/file"));
  EXPECT_TRUE(TakesThePlaceOf(folder_ / "link", folder_ / "a/file"));
  EXPECT_TRUE(TakesThePlaceOf(folder_ / "link", folder_ / "link"));
  EXPECT_FALSE(TakesThePlaceOf(folder_ / "a/file", folder_ / "link"));
  EXPECT_FALSE(TakesThePlaceOf(folder_ / "a/file", folder_ / "none/file"));
}

TEST(IsBelowTest, GoesByWholeNames) {
  EXPECT_TRUE(IsBelow("/a/b", "/a/b"));
  EXPECT_TRUE(IsBelow("/a/b", "/a/b/c/d"));
  EXPECT_TRUE(IsBelow("/", "/a"));
  EXPECT_FALSE(IsBelow("/a/b", "/a/bc"));
  EXPECT_FALSE(IsBelow("/a/b", "/a"));
}

}  // namespace
}  // namespace tilemend
