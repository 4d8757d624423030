#include "common/store/file_stamp.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "absl/time/clock.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class FileStampTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_.Write("tile.ply", "one");
  const absl::Time later_ = absl::Now() + absl::Minutes(1);
};

TEST_F(FileStampTest, StaysWhileTheFileDoes) {
  const std::string stamp = StampOf(path_, later_);
  EXPECT_NE(stamp, "");
  EXPECT_TRUE(HasStamp(path_, stamp));
  EXPECT_EQ(StampOf(path_, later_), stamp);
}

TEST_F(FileStampTest, IsAnotherWhenTheSizeOrTheTimeIs) {
  const std::string stamp = StampOf(path_, later_);
  std::filesystem::last_write_time(path_, std::filesystem::last_write_time(path_) - std::chrono::hours(1));
  EXPECT_FALSE(HasStamp(path_, stamp));
  const std::string before = StampOf(path_, later_);
  std::filesystem::resize_file(path_, 2);
  EXPECT_FALSE(HasStamp(path_, before));
}

TEST_F(FileStampTest, IsThatOfOneFile) {
  const std::string stamp = StampOf(path_, later_);
  std::filesystem::rename(folder_.Write("other.ply", "one"), path_);
  EXPECT_FALSE(HasStamp(path_, stamp));
}

TEST_F(FileStampTest, IsNotGivenForWhatHasJustChangedOrIsNotThere) {
  EXPECT_EQ(StampOf(path_, absl::Now()), "");
  EXPECT_EQ(YoungStampOf(path_), StampOf(path_, later_));
  EXPECT_EQ(YoungStampOf(folder_ / "none"), "");
  EXPECT_EQ(StampOf(folder_ / "none", later_), "");
  EXPECT_EQ(StampOf(folder_.path(), later_), "");
  EXPECT_FALSE(HasStamp(path_, ""));
}

}  // namespace
}  // namespace tilemend
