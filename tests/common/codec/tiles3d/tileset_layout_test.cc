#include "common/codec/tiles3d/tileset_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "common/codec/tiles3d/tileset_frame.h"
#include "common/util/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tileset_scene.h"

namespace tilemend {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class TilesetLayoutTest : public testing::Test {
 protected:
  void Write(const std::string& folder, const TilesetScene& scene) {
    for (const auto& [path, bytes] : scene.All()) folder_.Write(folder + "/" + path, bytes);
  }
  // Changes the JSON of a file.
  template <typename Change>
  void Edit(const std::string& path, const Change& change) {
    Json json = Json::parse(*ReadFile(folder_ / path));
    change(json);
    folder_.Write(path, json.dump());
  }
  std::string WarningOf(const std::string& folder) {
    const auto layout = ReadTilesetLayout(folder_ / folder, "tileset.json");
    EXPECT_TRUE(layout.ok()) << layout.status();
    EXPECT_EQ(layout->tilesets.size(), 1u);
    EXPECT_EQ(layout->tilesets[0].path, "tileset.json");
    EXPECT_TRUE(layout->tilesets[0].frame.empty());
    return layout->warning;
  }

  const TemporaryFolder folder_;
};

TEST_F(TilesetLayoutTest, TilesetsInFoldersOfTheirOwnAreParts) {
  Write("s", {.files = TilesetScene::Files::kOfTiles, .place = TilesetScene::Place::kOnEarth});
  const auto layout = ReadTilesetLayout(folder_ / "s", "tileset.json");
  ASSERT_TRUE(layout.ok()) << layout.status();
  ASSERT_EQ(layout->tilesets.size(), 2u);
  EXPECT_EQ(layout->tilesets[0].path, "Data/Tile_p000_p000/Tile_p000_p000.json");
  EXPECT_EQ(layout->tilesets[1].frame, (TileFrame{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
  EXPECT_THAT(layout->crs, HasSubstr("+lat_0=50 "));
  EXPECT_EQ(layout->warning, "");
}

TEST_F(TilesetLayoutTest, EarthCentredPartsHaveOneFrame) {
  Write("s", {.files = TilesetScene::Files::kOfTiles, .place = TilesetScene::Place::kEarthCentred});
  const auto layout = ReadTilesetLayout(folder_ / "s", "tileset.json");
  ASSERT_TRUE(layout.ok()) << layout.status();
  ASSERT_EQ(layout->tilesets.size(), 2u);
  EXPECT_EQ(layout->tilesets[0].frame, layout->tilesets[1].frame);
  const Eigen::Matrix4d to_scene = Eigen::Matrix4d(layout->tilesets[0].frame.data()) * TilesetScene::ToEarth();
  EXPECT_NEAR(Moved(to_scene, {64, 32, 2}).norm(), 0, 1e-7);
}

TEST_F(TilesetLayoutTest, OtherwiseItIsAllOne) {
  Write("one", {});
  EXPECT_EQ(WarningOf("one"), "");
  Write("s", {.files = TilesetScene::Files::kOfTiles});
  for (const char* file : {"s/x.glb", "s/Data/x.json", "s/x.json"}) folder_.Write(file, "");
  Edit("s/tileset.json", [](Json& json) { json["root"]["content"] = {{"uri", "x.glb"}}; });
  EXPECT_THAT(WarningOf("s"), HasSubstr("it has models of its own, such as x.glb"));
  Edit("s/tileset.json", [](Json& json) { json["root"].erase("content"); });
  Edit("s/tileset.json", [](Json& json) { json["root"]["children"][0]["content"]["uri"] = "Data/x.json"; });
  EXPECT_THAT(WarningOf("s"), HasSubstr("two tilesets lie in Data/"));
  Edit("s/tileset.json", [](Json& json) { json["root"]["children"][0]["content"]["uri"] = "x.json"; });
  EXPECT_THAT(WarningOf("s"), HasSubstr("x.json lies beside it"));
}

TEST_F(TilesetLayoutTest, ErrorsNameTheFile) {
  folder_.Write("s/tileset.json", "{");
  EXPECT_THAT(ReadTilesetLayout(folder_ / "s", "tileset.json").status().message(),
              HasSubstr(folder_ / "s/tileset.json: byte"));
  const absl::Status none = ReadTilesetLayout(folder_ / "s", "none.json").status();
  EXPECT_TRUE(absl::IsNotFound(none));
  EXPECT_THAT(none.message(), HasSubstr(folder_ / "s/none.json"));
}

TEST_F(TilesetLayoutTest, AMissingTilesetIsNamedWithTheOneThatNamesIt) {
  Write("s", {.files = TilesetScene::Files::kOfTiles});
  std::filesystem::remove(folder_ / "s/Data/Tile_p000_p000/Tile_p000_p000.json");
  const absl::Status missing = ReadTilesetLayout(folder_ / "s", "tileset.json").status();
  EXPECT_TRUE(absl::IsNotFound(missing)) << missing;
  EXPECT_THAT(missing.ToString(),
              HasSubstr("s/tileset.json: names Data/Tile_p000_p000/Tile_p000_p000.json, which is not"));
}

TEST_F(TilesetLayoutTest, TheEntryGrowsWithItsTilesets) {
  const TilesetScene scene{.files = TilesetScene::Files::kOfTiles};
  Write("s", scene);
  Write("out", scene);
  EXPECT_EQ(*GrownEntry(folder_ / "s", "tileset.json", folder_ / "out"), *ReadFile(folder_ / "s/tileset.json"));
  Edit("out/Data/Tile_p001_p000/Tile_p001_p000.json",
       [](Json& json) { json["root"]["boundingVolume"]["box"][2] = 20; });
  const auto grown = GrownEntry(folder_ / "s", "tileset.json", folder_ / "out");
  ASSERT_TRUE(grown.ok()) << grown.status();
  const Json was = Json::parse(*ReadFile(folder_ / "s/tileset.json"))["root"], root = Json::parse(*grown)["root"];
  EXPECT_EQ(root["children"][0], was["children"][0]);
  for (const Json& volume : {root["boundingVolume"], root["children"][1]["boundingVolume"]}) {
    const std::vector<double> box = volume["box"];
    EXPECT_NEAR(box[2] + box[11], 21, 1e-9);
    EXPECT_NEAR(box[2] - box[11], 1.5, 1e-9);
  }
}

TEST_F(TilesetLayoutTest, VolumesOfAllKindsGrowTheEntry) {
  const TilesetScene scene{.files = TilesetScene::Files::kOfTiles, .place = TilesetScene::Place::kEarthCentred};
  Write("s", scene);
  Write("out", scene);
  const auto set = [&](const Json& volume) {
    Edit("out/Data/Tile_p001_p000/Tile_p001_p000.json", [&](Json& json) {
      json["root"].erase("transform");
      json["root"]["boundingVolume"] = volume;
    });
    const auto grown = GrownEntry(folder_ / "s", "tileset.json", folder_ / "out");
    EXPECT_TRUE(grown.ok()) << grown.status();
    return Json::parse(*grown)["root"]["boundingVolume"]["sphere"][3].get<double>();
  };
  const Point3 middle = Moved(TilesetScene::ToEarth(), {64, 32, 2});
  EXPECT_GT(set({{"sphere", {middle.x(), middle.y(), middle.z(), 200}}}), 200);
  const Point3 geodetic = GeodeticOf(middle);
  EXPECT_GT(set({{"region", {geodetic.x(), geodetic.y(), geodetic.x() + 1e-5, geodetic.y() + 1e-5, 0, 300}}}), 290);
}

}  // namespace
}  // namespace tilemend
