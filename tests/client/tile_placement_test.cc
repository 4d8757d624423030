#include "client/tile_placement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "absl/strings/str_replace.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr char kTileset[] = R"({"asset": {"version": "1.1"}, "geometricError": 9, "root": {
  "boundingVolume": {"box": [0,0,0, 9,0,0, 0,9,0, 0,0,9]}, "geometricError": 8, "refine": "REPLACE", "children": [
  {"boundingVolume": {"sphere": [0,0,0, 5]}, "geometricError": 4, "content": {"uri": "a.glb"}},
  {"boundingVolume": {"region": [0.1,0.1,0.2,0.2,0,9]}, "geometricError": 4, "content": {"uri": "b.glb"}}]}})";

std::string ChangeBy(const std::string& from, const std::string& to) {
  const std::string changed = absl::StrReplaceAll(kTileset, {{from, to}});
  EXPECT_NE(changed, kTileset);
  return TilesetChange(kTileset, changed);
}

TEST(TilesetChangeTest, VolumesMayGrow) {
  EXPECT_EQ(TilesetChange(kTileset, kTileset), "");
  EXPECT_EQ(ChangeBy("0,0,9]", "0,0,12]"), "");
  EXPECT_EQ(ChangeBy("[0,0,0, 9,0,0, 0,9,0, 0,0,9]", "[0,0,-1.5, 9,0,0, 0,9,0, 0,0,10.5]"), "");
  EXPECT_EQ(ChangeBy("[0,0,0, 5]", "[0,0,0, 6]"), "");
  EXPECT_EQ(ChangeBy("0.2,0.2,0,9]", "0.2,0.3,-1,10]"), "");
}

TEST(TilesetChangeTest, VolumesMustHoldWhatTheyHeld) {
  const auto is_small = HasSubstr("bounding volume");
  EXPECT_THAT(ChangeBy("[0,0,0, 9", "[900000,0,0, 9"), is_small);
  EXPECT_THAT(ChangeBy("0,0,9]", "0,0,8]"), is_small);
  EXPECT_THAT(ChangeBy("[0,0,0, 5]", "[0,1,0, 5.5]"), is_small);
  EXPECT_THAT(ChangeBy("0.2,0.2,0,9]", "0.2,0.2,1,9]"), is_small);
  EXPECT_THAT(ChangeBy("[0.1,0.1", "[0.11,0.1"), is_small);
  EXPECT_THAT(ChangeBy(R"("sphere": [0,0,0, 5])", R"("box": [0,0,0, 9,0,0, 0,9,0, 0,0,9])"), is_small);
}

TEST(TilesetChangeTest, NothingElseMayDiffer) {
  const auto is_other = HasSubstr("other tiles");
  EXPECT_THAT(ChangeBy("\"geometricError\": 4", "\"geometricError\": 0"), is_other);
  EXPECT_THAT(ChangeBy("REPLACE", "ADD"), is_other);
  EXPECT_THAT(ChangeBy("a.glb", "b.glb"), is_other);
  EXPECT_THAT(ChangeBy("\"refine\"", "\"transform\": [1,0,0,0,0,1,0,0,0,0,1,0,0,0,500,1], \"refine\""), is_other);
}

class ChangedPlacementTest : public ::testing::Test {
 protected:
  ChangedPlacementTest() {
    scene_.root = folder_ / "in";
    scene_.crs = "EPSG:25832";
    scene_.origin = {500000, 5600000, 0};
    scene_.grid.cell_size = {10, 10};
    scene_.cols = scene_.rows = 1;
    scene_.tiles = {{{0, 0}, "a.obj"}};
    folder_.Write("in/metadata.xml", "<ModelMetadata/>");
    folder_.Write("out/metadata.xml", "<ModelMetadata/>");
    folder_.Write("out/a.obj", "");
    folder_.Write("out/scene.json", SceneJson(scene_));
  }
  void WriteChanged(const std::string& from, const std::string& to) {
    folder_.Write("out/scene.json", absl::StrReplaceAll(SceneJson(scene_), {{from, to}}));
  }
  std::vector<std::string> Changed(bool has_area = true) { return ChangedPlacement(scene_, folder_ / "out", has_area); }

  const TemporaryFolder folder_;
  Scene scene_;
};

TEST_F(ChangedPlacementTest, FilesAsTheRunWritesThemAreRight) { EXPECT_THAT(Changed(), IsEmpty()); }

TEST_F(ChangedPlacementTest, MissingFilesAreNamed) {
  std::filesystem::remove(folder_ / "out/metadata.xml");
  std::filesystem::remove(folder_ / "out/scene.json");
  EXPECT_THAT(Changed(), ElementsAre("metadata.xml: missing", "scene.json: missing"));
  std::filesystem::remove(folder_ / "in/metadata.xml");
  EXPECT_THAT(Changed(), ElementsAre("scene.json: missing"));
}

TEST_F(ChangedPlacementTest, AnotherPlaceIsNamed) {
  folder_.Write("out/metadata.xml", "<ModelMetadata><SRSOrigin>0,0,500</SRSOrigin></ModelMetadata>");
  EXPECT_THAT(Changed(), ElementsAre("metadata.xml: changed"));
  folder_.Write("out/metadata.xml", "<ModelMetadata/>");
  WriteChanged("500000", "500500");
  EXPECT_THAT(Changed(), ElementsAre("scene.json: another origin"));
  WriteChanged("25832", "25833");
  EXPECT_THAT(Changed(), ElementsAre("scene.json: another CRS"));
  WriteChanged("\"cell_size\": 10", "\"cell_size\": 11");
  EXPECT_THAT(Changed(), ElementsAre("scene.json: another grid"));
  EXPECT_THAT(Changed(false), IsEmpty()) << "the area may have given it another grid";
  WriteChanged("a.obj", "b.obj");
  EXPECT_THAT(Changed(), ElementsAre("scene.json: it does not have a.obj in cell 0,0"));
}

TEST_F(ChangedPlacementTest, TilesThatAreNotThereAreNotAskedFor) {
  std::filesystem::remove(folder_ / "out/a.obj");
  WriteChanged("\"a.obj\"", "null");
  EXPECT_THAT(Changed(), IsEmpty());
}

TEST_F(ChangedPlacementTest, TilesetsAreCompared) {
  scene_.tileset = "tileset.json";
  scene_.tiles = {{{0, 0}, "tileset.json"}};
  folder_.Write("out/scene.json", SceneJson(scene_));
  folder_.Write("in/tileset.json", kTileset);
  EXPECT_THAT(Changed(), ElementsAre(HasSubstr("tileset.json: ")));
  folder_.Write("out/tileset.json", kTileset);
  EXPECT_THAT(Changed(), IsEmpty());
  std::filesystem::remove(folder_ / "out/scene.json");
  EXPECT_THAT(Changed(), ElementsAre("scene.json: missing")) << "a tileset does not say what the area is";
  folder_.Write("out/scene.json", SceneJson(scene_));
  folder_.Write("out/tileset.json",
                absl::StrReplaceAll(kTileset, {{"\"geometricError\": 4", "\"geometricError\": 0"}}));
  EXPECT_THAT(Changed(), ElementsAre(HasSubstr("tileset.json: other tiles")));
}

}  // namespace
}  // namespace tilemend
