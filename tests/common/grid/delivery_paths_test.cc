#include "common/grid/delivery_paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

Scene SceneOf(const std::vector<std::string>& paths) {
  Scene scene;
  for (int32_t col = 0; col < std::ssize(paths); ++col) {
    scene.tiles.push_back({.cell = {col, 0}, .path = paths[static_cast<size_t>(col)]});
  }
  return scene;
}

TEST(DeliveryPathsTest, TilesetsGetFoldersWithoutPlus) {
  Scene scene = SceneOf({"Data/Tile_+000_-014/Tile_+000_-014.osgb", ""});
  ASSERT_TRUE(SetDeliveryPaths("3dtiles", scene).ok());
  EXPECT_EQ(OutputPath(scene.tiles[0]), "Data/Tile_p000_m014/Tile_p000_m014.json");
  EXPECT_EQ(OutputPath(scene.tiles[1]), "tiles/Tile_p001_p000/Tile_p001_p000.json");
  EXPECT_TRUE(IsDelivered(scene));
}

TEST(DeliveryPathsTest, EachTileGetsAFolderOfItsOwn) {
  Scene scene = SceneOf({"a_+000_+000.obj", "a_+001_+000.obj"});
  ASSERT_TRUE(SetDeliveryPaths("3dtiles", scene).ok());
  EXPECT_EQ(OutputPath(scene.tiles[0]), "a_p000_p000/a_p000_p000.json");
  EXPECT_EQ(OutputPath(scene.tiles[1]), "a_p001_p000/a_p001_p000.json");
}

TEST(DeliveryPathsTest, TheSameFormatStaysAsItIs) {
  for (const auto& [format, path] : {std::pair("osgb", "a/a.osgb"),
                                     {"3dtiles", "a/a.json"},
                                     {"obj", "a.obj"},
                                     {"ply", "a.ply"},
                                     {"same", "a.obj"}}) {
    Scene scene = SceneOf({path, ""});
    ASSERT_TRUE(SetDeliveryPaths(format, scene).ok()) << format;
    EXPECT_FALSE(IsDelivered(scene)) << format;
    EXPECT_EQ(OutputPath(scene.tiles[0]), path);
  }
}

TEST(DeliveryPathsTest, WhatWouldLoseSomethingIsRefusedWithAReason) {
  const struct {
    std::string path, format, why;
  } cases[] = {{"a.ply", "3dtiles", "colours at vertices"},   {"a.ply", "obj", "colours at vertices"},
               {"a.obj", "ply", "no place for their images"}, {"a/a.osgb", "ply", "no place for their images"},
               {"a.obj", "osgb", "for OSGB tiles alone"},     {"a/a.json", "osgb", "for OSGB tiles alone"}};
  for (const auto& c : cases) {
    Scene scene = SceneOf({c.path});
    const absl::Status status = SetDeliveryPaths(c.format, scene);
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << c.path << " as " << c.format;
    EXPECT_THAT(std::string(status.message()), HasSubstr(c.why));
  }
}

TEST(DeliveryPathsTest, MixedFormatsAndEqualNamesAreRefused) {
  Scene mixed = SceneOf({"a/a.osgb", "b/b.json"});
  EXPECT_THAT(std::string(SetDeliveryPaths("3dtiles", mixed).message()), HasSubstr("tiles of one format"));
  Scene equal = SceneOf({"a.obj", "a/a.OBJ"});
  EXPECT_THAT(std::string(SetDeliveryPaths("3dtiles", equal).message()), HasSubstr("as another tile"));
}

TEST(DeliveryPathsTest, TheDeliveredSceneHasTheTilesThatAreThere) {
  const TemporaryFolder folder;
  folder.Write("a/a.obj", "v 0 0 0\n");
  Scene scene = SceneOf({"a/a.osgb", "b/b.osgb"});
  ASSERT_TRUE(SetDeliveryPaths("obj", scene).ok());
  const Scene delivered = DeliveredScene(scene, folder.path());
  EXPECT_EQ(delivered.tiles[0].path, "a/a.obj");
  EXPECT_EQ(delivered.tiles[1].path, "");
}

}  // namespace
}  // namespace tilemend
