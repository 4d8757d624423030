#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common/grid/scene.h"
#include "common/grid/scene_sources.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

constexpr char kTileset[] = R"({"asset": {"version": "1.1"}, "root": {}})";

class SceneTilesetTest : public testing::Test {
 protected:
  // A tile of 100 m with an overlap of 1 m.
  void Add(const std::string& path, int col, int row) {
    tiles_.tiles.push_back(
        {path, TileFrame(16, col), {{100.0 * col - 1, 100.0 * row - 1, 0}, {100.0 * col + 101, 100.0 * row + 101, 9}}});
  }
  absl::StatusOr<Scene> Load(const std::string& path) {
    return LoadScene(path, nullptr, [&](const std::string& folder, const std::string& entry) {
      EXPECT_EQ(folder, folder_.path());
      EXPECT_EQ(entry, entry_);
      return tiles_;
    });
  }
  std::string Problem() { return std::string(Load(folder_.path()).status().message()); }

  const TemporaryFolder folder_;
  std::string entry_ = "tileset.json";
  TilesetTiles tiles_;
};

TEST_F(SceneTilesetTest, ATilesetWithoutOthersIsOneCell) {
  folder_.Write("tileset.json", kTileset);
  folder_.Write("Data/Tile_+000_+001.ply", "not looked at");
  tiles_ = {"+proj=ortho", 50, {{"tileset.json", {}, {{-3.5, 10, 0}, {96.2, 10.5, 7}}}}, "why"};
  const auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->tiles.size(), 1u);
  EXPECT_EQ(scene->tiles[0].path, "tileset.json");
  EXPECT_EQ(scene->tileset, "");
  EXPECT_EQ(scene->crs, "+proj=ortho");
  EXPECT_EQ(scene->origin, Point3(0, 0, 50));
  EXPECT_EQ(scene->grid.corner, Point2(-4, 10));
  EXPECT_EQ(scene->grid.cell_size, Point2(101, 1));
  EXPECT_FALSE(scene->area_known);
  EXPECT_EQ(scene->warnings[0], "why");
  EXPECT_THAT(scene->warnings[1], HasSubstr("one cell of 101 x 1 m"));
  EXPECT_TRUE(Load(folder_ / "tileset.json").ok()) << "the entry's path is the scene's as well";
}

TEST_F(SceneTilesetTest, TilesetsAreCellsByTheirNames) {
  folder_.Write(entry_ = "Production_1.json", kTileset);
  folder_.Write("options.json", R"({"asset": 1})");
  Add("Data/Tile_m001_p002/Tile_m001_p002.json", 3, 2);
  Add("Data/Tile_p000_p002/tileset.json", 4, 2);
  auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->tiles.size(), 2u);
  EXPECT_EQ(scene->tileset, "Production_1.json");
  EXPECT_EQ(scene->tiles[0].cell, (CellId{0, 2}));
  EXPECT_EQ(scene->tiles[1].cell, (CellId{1, 2}));
  EXPECT_EQ(scene->tiles[1].frame, TileFrame(16, 4));
  EXPECT_EQ(scene->grid.cell_size.x(), 100);
  for (const SceneTile& tile : scene->tiles) folder_.Write(tile.path, kTileset);
  folder_.Write("scene.json", SceneJson(*scene));
  const auto again = LoadScene(folder_.path(), nullptr);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->tileset, scene->tileset);
  EXPECT_EQ(again->tiles[1].frame, scene->tiles[1].frame);
}

TEST_F(SceneTilesetTest, TilesetsWithOtherNamesAreCellsByTheirPlaces) {
  folder_.Write("tileset.json", kTileset);
  Add("Data/a/tileset.json", 1, 1);
  Add("Data/b/tileset.json", 0, 1);
  Add("Data/c/tileset.json", 0, 0);
  const auto scene = Load(folder_.path());
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->tiles[0].path, "Data/c/tileset.json");
  EXPECT_EQ(scene->tiles[2].path, "Data/a/tileset.json");
  EXPECT_EQ(scene->tiles[2].cell, (CellId{1, 1}));
  EXPECT_EQ(scene->cols, 2);
  tiles_.tiles[1].bounds = tiles_.tiles[0].bounds;
  EXPECT_THAT(Problem(), HasSubstr("are both in cell +001_+001; the tilesets have to lie in a regular plane grid"));
}

TEST_F(SceneTilesetTest, RefusesWhatIsNoGrid) {
  folder_.Write("tileset.json", kTileset);
  Add("Data/Tile_p000_p000_p000/t.json", 0, 0);
  EXPECT_THAT(Problem(), HasSubstr("a name with three numbers"));
  folder_.Write("tileset.json", kTileset);
  EXPECT_TRUE(absl::IsFailedPrecondition(LoadScene(folder_.path(), nullptr).status()));
}

TEST_F(SceneTilesetTest, FindsTheEntry) {
  EXPECT_EQ(*FindTileset(folder_.path()), "");
  folder_.Write("a.json", kTileset);
  folder_.Write("notes.json", "no JSON");
  EXPECT_EQ(*FindTileset(folder_.path()), "a.json");
  folder_.Write("b.json", kTileset);
  EXPECT_THAT(std::string(FindTileset(folder_.path()).status().message()), HasSubstr("a.json and b.json are both"));
  folder_.Write("tileset.json", "damaged");
  EXPECT_EQ(*FindTileset(folder_.path()), "tileset.json");
  EXPECT_TRUE(LooksLikeTileset(folder_ / "a.json"));
  EXPECT_FALSE(LooksLikeTileset(folder_ / "tileset.json"));
  EXPECT_FALSE(LooksLikeTileset(folder_ / "none.json"));
}

TEST_F(SceneTilesetTest, ErrorsOfTheTilesetAreThoseOfTheScene) {
  folder_.Write("tileset.json", "{}");
  const auto scene = LoadScene(folder_.path(), nullptr, [](const std::string&, const std::string&) {
    return absl::InvalidArgumentError("bad");
  });
  EXPECT_EQ(scene.status(), absl::InvalidArgumentError("bad"));
}

TEST_F(SceneTilesetTest, ATilesetHasItsFolderForItself) {
  folder_.Write("a/tileset.json", "{}");
  folder_.Write("a/b/c.ply", "ply");
  folder_.Write("scene.json", R"({"cell_size": 10, "cols": 2, "rows": 1, "tiles": [
      {"col": 0, "row": 0, "path": "a/b/c.ply"}, {"col": 1, "row": 0, "path": "a/tileset.json"}]})");
  EXPECT_THAT(Problem(), HasSubstr("tiles[0] (a/b/c.ply) lies in the folder of the tileset tiles[1] (a/tileset.json)"));
}

TEST_F(SceneTilesetTest, ReadsFieldsOfTilesetsWithCare) {
  folder_.Write("a/tileset.json", "{}");
  const auto with = [&](const std::string& head, const std::string& frame) {
    folder_.Write("scene.json", R"({"cell_size": 10, "cols": 1, "rows": 1,)" + head +
                                    R"("tiles": [{"col": 0, "row": 0, "path": "a/tileset.json")" + frame + "}]}");
    return Problem();
  };
  EXPECT_EQ(with("", ""), "");
  EXPECT_THAT(with("", R"(, "frame": [1, 2])"), HasSubstr("frame"));
  EXPECT_THAT(with(R"("tileset": "../x.json",)", ""), HasSubstr("expected a name without folder"));
  EXPECT_THAT(with(R"("tileset": "report.json",)", ""), HasSubstr("expected the name of a .json file"));
}

}  // namespace
}  // namespace tilemend
