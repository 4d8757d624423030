#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/grid/scene.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

TEST(SceneTilesetTest, TheTilesetIsOneCell) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("tileset.json", "{}");
  folder.Write("Data/Tile_+000_+001.ply", "not looked at");
  const auto scene = LoadScene(folder.path(), [&](const std::string& tile) -> absl::StatusOr<Box> {
    EXPECT_EQ(tile, path);
    return Box{{-3.5, 10, 0}, {96.2, 10.5, 7}};
  });
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->tiles.size(), 1u);
  EXPECT_EQ(scene->tiles[0].path, "tileset.json");
  EXPECT_EQ(scene->grid.corner, Point2(-4, 10));
  EXPECT_EQ(scene->grid.cell_size, Point2(101, 1));
  EXPECT_FALSE(scene->area_known);
  EXPECT_THAT(scene->warnings[0], HasSubstr("one cell of 101 x 1 m"));
  folder.Write("scene.json", SceneJson(*scene));
  const auto again = LoadScene(folder.path(), nullptr);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->tiles[0].path, "tileset.json");
}

TEST(SceneTilesetTest, ErrorsOfTheTilesetAreThoseOfTheScene) {
  const TemporaryFolder folder;
  folder.Write("tileset.json", "{}");
  const auto scene = LoadScene(folder.path(), [](const std::string&) { return absl::InvalidArgumentError("bad"); });
  EXPECT_EQ(scene.status(), absl::InvalidArgumentError("bad"));
}

TEST(SceneTilesetTest, ATilesetHasItsFolderForItself) {
  const TemporaryFolder folder;
  folder.Write("a/tileset.json", "{}");
  folder.Write("a/b/c.ply", "ply");
  folder.Write("scene.json", R"({"cell_size": 10, "cols": 2, "rows": 1, "tiles": [
      {"col": 0, "row": 0, "path": "a/b/c.ply"}, {"col": 1, "row": 0, "path": "a/tileset.json"}]})");
  const auto scene = LoadScene(folder.path(), nullptr);
  EXPECT_THAT(scene.status().message(),
              HasSubstr("tiles[0] (a/b/c.ply) lies in the folder of the tileset tiles[1] (a/tileset.json)"));
}

}  // namespace
}  // namespace tilemend
