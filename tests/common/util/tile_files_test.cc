#include "common/util/tile_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/util/file_pack.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;

class TileFilesTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string tree_ = folder_.Write("Tile_+000_+000/Tile_+000_+000.osgb", "root");
};

TEST_F(TileFilesTest, ATreeHasAllFilesOfItsFolder) {
  folder_.Write("Tile_+000_+000/Tile_+000_+000_L18_0.osgb", "fine");
  folder_.Write("Tile_+000_+000/Tile_+000_+000_L17.OSGB", "middle");
  folder_.Write("Tile_+000_+000/notes.txt", "no tile");
  const auto names = FilesOfTile(tree_);
  ASSERT_TRUE(names.ok()) << names.status();
  EXPECT_THAT(*names, ElementsAre("Tile_+000_+000.osgb", "Tile_+000_+000_L17.OSGB", "Tile_+000_+000_L18_0.osgb"));
  const auto bytes = ReadTileBytes(tree_);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  EXPECT_EQ(*SizeOfTile(tree_), static_cast<int64_t>(bytes->size()));
  const auto files = UnpackFiles(*bytes, tree_);
  ASSERT_TRUE(files.ok()) << files.status();
  EXPECT_EQ((*files)[1].bytes, "middle");
}

TEST_F(TileFilesTest, AMeshFileIsItsOwnTile) {
  const std::string path = folder_.Write("a.ply", "ply");
  EXPECT_FALSE(IsTileTree(path));
  EXPECT_THAT(*FilesOfTile(path), ElementsAre("a.ply"));
  EXPECT_EQ(*ReadTileBytes(path), "ply");
  EXPECT_EQ(*SizeOfTile(path), 3);
}

TEST_F(TileFilesTest, SaysWhatIsNotThere) {
  EXPECT_TRUE(absl::IsNotFound(ReadTileBytes(folder_.path() + "/none/a.osgb").status()));
  EXPECT_TRUE(absl::IsNotFound(ReadTileBytes(folder_.path() + "/a.ply").status()));
}

}  // namespace
}  // namespace tilemend
