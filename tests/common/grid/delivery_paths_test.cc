#include "common/grid/delivery_paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_join.h"
#include "common/grid/scene_sources.h"
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
  } cases[] = {{"a.ply", "3dtiles", "colours at vertices"},
               {"a.ply", "obj", "colours at vertices"},
               {"a.obj", "osgb", "reach 5600000 m, where these are 0.5 m apart"}};
  for (const auto& c : cases) {
    Scene scene = SceneOf({c.path});
    scene.grid.corner = {500000, 5600000};
    const absl::Status status = SetDeliveryPaths(c.format, scene);
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << c.path << " as " << c.format;
    EXPECT_THAT(std::string(status.message()), HasSubstr(c.why));
  }
}

TEST(DeliveryPathsTest, OsgbTilesLieInDataWithSigns) {
  Scene scene = SceneOf({"Data/Tile_p000_m014/Tile_p000_m014.json", "a_+001_+000.json"});
  ASSERT_TRUE(SetDeliveryPaths("osgb", scene).ok());
  EXPECT_EQ(OutputPath(scene.tiles[0]), "Data/Tile_+000_-014/Tile_+000_-014.osgb");
  EXPECT_EQ(OutputPath(scene.tiles[1]), "Data/a_+001_+000/a_+001_+000.osgb");
}

TEST(DeliveryPathsTest, WhatTheFormatCannotHoldIsAWarning) {
  const auto warnings = [](const std::string& path, std::string_view format) {
    Scene scene = SceneOf({path});
    scene.cols = scene.rows = 4;
    scene.grid.cell_size = {300, 300};
    EXPECT_TRUE(SetDeliveryPaths(format, scene).ok());
    return absl::StrJoin(scene.warnings, "\n");
  };
  EXPECT_THAT(warnings("a/a.osgb", "ply"), HasSubstr("finest level of detail alone"));
  EXPECT_EQ(warnings("a/a.osgb", "3dtiles"), "");
  EXPECT_THAT(warnings("a.obj", "ply"), HasSubstr("its image is written, or its diffuse colour"));
  EXPECT_THAT(warnings("a/a.json", "osgb"), HasSubstr("rounded to float32, by 6.1e-05 m at most"));
}

TEST(DeliveryPathsTest, MetadataIsReadBack) {
  Scene scene = SceneOf({"a.obj"});
  scene.crs = "EPSG:25832 <&>";
  scene.origin = {500000.25, 5600000, 1.0 / 3};
  Scene read;
  ASSERT_TRUE(ParseMetadata(MetadataXml(scene), "metadata.xml", &read).ok());
  EXPECT_EQ(read.crs, scene.crs);
  EXPECT_EQ(read.origin, scene.origin);
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
  const auto delivered = DeliveredScene(scene, folder.path());
  ASSERT_TRUE(delivered.ok()) << delivered.status();
  EXPECT_EQ(delivered->tiles[0].path, "a/a.obj");
  EXPECT_EQ(delivered->tiles[1].path, "");
  EXPECT_TRUE(delivered->tiles[0].frame.empty());
}

TEST(DeliveryPathsTest, DeliveredTilesetsHaveTheFrameOfTheScene) {
  const TemporaryFolder folder;
  folder.Write("a/a.json", "{}");
  Scene scene = SceneOf({"a/a.obj", "b/b.obj"});
  ASSERT_TRUE(SetDeliveryPaths("3dtiles", scene).ok());
  const auto delivered = DeliveredScene(scene, folder.path());
  ASSERT_TRUE(delivered.ok()) << delivered.status();
  const TileFrame& frame = delivered->tiles[0].frame;
  ASSERT_EQ(frame.size(), 16U);
  for (size_t i = 0; i < 16; ++i) EXPECT_EQ(frame[i], i % 5 == 0 ? 1 : 0);
  EXPECT_TRUE(delivered->tiles[1].frame.empty()) << "it is not there";
}

TEST(DeliveryPathsTest, TheFilledSceneHasTilesThatWereAdded) {
  const TemporaryFolder folder;
  folder.Write("tiles/Tile_+001_+000.ply", "ply\n");
  Scene scene = SceneOf({"a/a.osgb", "", ""});
  for (int32_t col = 0; col < 3; ++col) scene.tiles[static_cast<size_t>(col)].cell = {col, 0};
  const auto filled = FilledScene(scene, folder.path());
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(filled->tiles[0].path, "a/a.osgb") << "whether it is there yet or not";
  EXPECT_EQ(filled->tiles[1].path, "tiles/Tile_+001_+000.ply");
  EXPECT_EQ(filled->tiles[2].path, "");
}

}  // namespace
}  // namespace tilemend
