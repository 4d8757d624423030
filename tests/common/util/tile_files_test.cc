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

TEST_F(TileFilesTest, ATilesetHasTheModelsBelowItsFolder) {
  const std::string path = folder_.Write("scene/tileset.json", "entry");
  for (const char* const file :
       {"scene/Data/b.json", "scene/Data/b.B3DM", "scene/a.glb", "scene/Data/deep/c.glb", "scene/scene.json",
        "scene/report.json", "scene/acceptance.json", "scene/holes.csv", "scene/.hidden/d.glb", "scene/.e.glb",
        "scene/f.osgb", "scene/Data/c.JPG", "beside.glb"}) {
    folder_.Write(file, "file");
  }
  EXPECT_THAT(*FilesOfTile(path),
              ElementsAre("tileset.json", "Data/b.B3DM", "Data/b.json", "Data/c.JPG", "Data/deep/c.glb", "a.glb"));
  const auto bytes = ReadTileBytes(path);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  EXPECT_EQ(*SizeOfTile(path), static_cast<int64_t>(bytes->size()));
}

TEST_F(TileFilesTest, AFrameIsTheLastFileOfATileset) {
  const std::string path = folder_.Write("scene/tileset.json", "entry");
  TileFrame frame(16, 0.5);
  frame[3] = -7;
  const auto bytes = ReadTileBytes(path, frame);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto files = UnpackFiles(*bytes, path);
  ASSERT_TRUE(files.ok()) << files.status();
  EXPECT_EQ(*SizeOfTile(path, frame), static_cast<int64_t>(bytes->size()));
  EXPECT_EQ(files->back().name, kFrameFile);
  EXPECT_EQ(FrameIn(files->back().bytes), frame);
  EXPECT_THAT(FrameIn("too short"), ::testing::IsEmpty());
  EXPECT_EQ(*ReadTileBytes(tree_, frame), *ReadTileBytes(tree_)) << "other trees have none";
}

TEST_F(TileFilesTest, FoldersAreNotFollowedForEver) {
  std::string folder = "scene/";
  for (int i = 0; i < 20; ++i) folder += "d/";
  folder_.Write(folder + "a.glb", "file");
  EXPECT_TRUE(absl::IsResourceExhausted(FilesOfTile(folder_.Write("scene/t.json", "entry")).status()));
}

TEST(TileNamesTest, ATreeIsToldByItsName) {
  for (const char* const path : {"a.osgb", "b/c.OSGB", "tileset.json", "Data/T/T.JSON"}) EXPECT_TRUE(IsTileTree(path));
  for (const char* const path : {"a.ply", "scene.json", "a/Report.json", "a.glb"}) EXPECT_FALSE(IsTileTree(path));
  EXPECT_TRUE(IsTileset("a.json"));
  EXPECT_FALSE(IsTileset("a.osgb"));
  EXPECT_TRUE(IsTreeFile("a.glb") && IsTreeFile("a.b3dm"));
  EXPECT_FALSE(IsTreeFile("a.jpg"));
}

TEST(TileNamesTest, FilesOfATreeLieInItsFolder) {
  EXPECT_TRUE(IsFileOfTree("T/a.osgb", "T/b.osgb"));
  EXPECT_TRUE(IsFileOfTree("T/a.json", "T/b.glb"));
  EXPECT_TRUE(IsFileOfTree("T/a.json", "T/U/b.json"));
  EXPECT_TRUE(IsFileOfTree("a.json", "U/b.b3dm"));
  EXPECT_FALSE(IsFileOfTree("T/a.osgb", "T/U/b.osgb"));
  EXPECT_FALSE(IsFileOfTree("T/a.osgb", "T/b.glb"));
  EXPECT_FALSE(IsFileOfTree("T/a.json", "U/b.glb"));
  EXPECT_FALSE(IsFileOfTree("T/a.json", "T/b.osgb"));
  EXPECT_FALSE(IsFileOfTree("T/a.json", "T/./b.glb"));
  EXPECT_FALSE(IsFileOfTree("a.json", ".hidden/b.glb"));
  EXPECT_FALSE(IsFileOfTree("T/a.json", "T/b.jpg"));
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
