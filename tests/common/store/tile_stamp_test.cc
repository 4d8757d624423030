#include "common/store/tile_stamp.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "absl/time/clock.h"
#include "common/store/digest.h"
#include "common/store/file_stamp.h"
#include "common/util/tile_files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class TileStampTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string tree_ = folder_.Write("tile/a.osgb", "root");
  const std::string finer_ = folder_.Write("tile/a_L18.osgb", "fine");
  const absl::Time later_ = absl::Now() + absl::Minutes(1);
};

TEST_F(TileStampTest, StaysWhileAllFilesDo) {
  const std::string stamp = StampOfTile(tree_, later_);
  EXPECT_NE(stamp, "");
  EXPECT_TRUE(TileHasStamp(tree_, stamp));
  EXPECT_FALSE(TileHasStamp(tree_, ""));
}

TEST_F(TileStampTest, IsAnotherWhenAFileOfTheTreeIs) {
  const std::string stamp = StampOfTile(tree_, later_);
  std::filesystem::resize_file(finer_, 2);
  EXPECT_FALSE(TileHasStamp(tree_, stamp));
}

TEST_F(TileStampTest, IsAnotherWhenTheTreeGetsAFile) {
  const std::string stamp = StampOfTile(tree_, later_);
  folder_.Write("tile/a_L19.osgb", "finer");
  EXPECT_FALSE(TileHasStamp(tree_, stamp));
}

TEST_F(TileStampTest, OfAMeshFileIsTheFiles) {
  const std::string path = folder_.Write("b.ply", "ply");
  EXPECT_EQ(StampOfTile(path, later_), StampOf(path, later_));
}

TEST_F(TileStampTest, DigestsAllFiles) {
  const std::string digest = FileDigest(*ReadTileBytes(tree_));
  EXPECT_TRUE(*TileHasDigest(tree_, digest));
  std::filesystem::resize_file(finer_, 2);
  EXPECT_FALSE(*TileHasDigest(tree_, digest));
}

}  // namespace
}  // namespace tilemend
