#include "common/codec/tiles3d/new_tileset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/codec/tiles3d/tileset.h"
#include "common/codec/tiles3d/tileset_frame.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

Eigen::AlignedBox3d Box(double lo, double hi) { return {Point3(lo, lo, 0), Point3(hi, hi, 10)}; }

NewTile Tile() {
  NewTile root{"a b+.glb", 2, Box(0, 8), std::nullopt, {}};
  root.children.push_back({"finer.glb", 4, Box(0, 4), std::nullopt, {}});
  return root;
}

TEST(NewTilesetTest, IsReadAsItWasGiven) {
  const TemporaryFolder folder;
  folder.Write("tileset.json", NewTileset(Tile()));
  const auto read = ReadTileset(FolderSource(folder.path()), "tileset.json");
  ASSERT_TRUE(read.ok()) << read.status();
  ASSERT_EQ(read->tiles.size(), 2u);
  EXPECT_EQ(read->tiles[0].content, "a b+.glb");
  EXPECT_EQ(read->tiles[0].geometric_error, 4) << "at least that of what takes its place";
  EXPECT_EQ(read->tiles[1].content, "finer.glb");
  EXPECT_EQ(read->tiles[1].volume.numbers, (std::vector<double>{2, 2, 5, 2, 0, 0, 0, 2, 0, 0, 0, 5}));
}

TEST(NewTilesetTest, AnEntryHoldsItsPartsOnTheEarth) {
  const TemporaryFolder folder;
  folder.Write("p/p.json", NewTileset(Tile()));
  Eigen::Matrix4d root = Eigen::Matrix4d::Identity();
  root.topLeftCorner<3, 3>() = AxesAt(Point3(0.2, 0.8, 0));
  root.topRightCorner<3, 1>() = tilemend::EarthCentred(Point3(0.2, 0.8, 100));
  Eigen::Matrix4d part = root;
  part.topRightCorner<3, 1>() += root.topLeftCorner<3, 3>() * Point3(100, 0, 0);
  const auto text = NewEntry(folder.path(), {{"p/p.json", part}}, root);
  ASSERT_TRUE(text.ok()) << text.status();
  folder.Write("tileset.json", *text);
  const auto read = ReadTileset(FolderSource(folder.path()), "tileset.json");
  ASSERT_TRUE(read.ok()) << read.status();
  const TilesetFrame frame = FrameOf(*read);
  EXPECT_TRUE(frame.is_roots);
  EXPECT_NEAR(read->tiles[0].volume.numbers[0], 104, 1e-6);
  EXPECT_EQ(read->tiles.back().content, "p/finer.glb");
  EXPECT_LT((Moved(ToScene(frame, read->tiles.back()), Point3(1, 2, 3)) - Point3(101, 2, 3)).norm(), 1e-6);
}

TEST(NewTilesetTest, AMissingPartIsAnError) {
  EXPECT_FALSE(NewEntry("/no/such/folder", {{"p.json", Eigen::Matrix4d::Identity()}}, std::nullopt).ok());
}

}  // namespace
}  // namespace tilemend
